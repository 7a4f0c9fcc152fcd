#include "linkwork/assembly/inerters.hpp"

#include <memory>
#include <utility>

#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

/// Where an inerter is in the equations of a linear solver: it is never evaluated, but for a pose to begin with.
class InerterRow final : public SpecialJoint {
 public:
  InerterRow(int i, int j) : bodies_{i, j} {}
  const std::vector<int>& bodies() const override { return bodies_; }
  HistoryKind history_kind() const override { return HistoryKind::none; }
  int history_size() const override { return 0; }
  void evaluate(const BodyState<double>*, const Signal<double>*, const SpecialHistory&,
                const SpecialRows&) const override {}
  SpecialJointPtr seen_from(const Vec3<double>&) const override { return std::make_shared<InerterRow>(*this); }

 private:
  std::vector<int> bodies_;
};

/// 0 of other force elements, and of a Model::without_inertances.
double inertance_of(const Model& model, const Element& force) {
  return force_kinds()[force.kind].inertia ? model.force_parameters()[force.first_parameter].constant : 0.0;
}

}  // namespace

Inerters::Inerters(const Model& model, std::ptrdiff_t D) : D_(D) {
  for (std::size_t force = 0; force < model.forces().size(); ++force) {
    const Element& it = model.forces()[force];
    if (const double inertance = inertance_of(model, it); inertance != 0.0)
      all_.push_back({it.i, it.j, static_cast<int>(force), inertance});
  }
}

double Inerters::rate(std::size_t k, const double* D, const double* x) const {
  double sum = 0.0;
  for (const Part& part : row(k, D))
    if (part.body != ground)
      for (int c = 0; c < velocity_size; ++c) sum += part.d[c] * x[velocity_size * std::ptrdiff_t{part.body} + c];
  return sum;
}

Model Inerters::as_joints(const Model& model) {
  Model out = model.without_forces();
  for (std::size_t k = 0; k < model.forces().size(); ++k) {
    const Element& element = model.forces()[k];
    if (inertance_of(model, element) == 0.0) continue;
    std::string name = "of " + model.force_names().name(static_cast<int>(k));
    while (out.joint_names().find(name) >= 0) name += "'";
    out.add_special_joint("coupler", name, element.i, element.j, element.at,
                          std::make_shared<InerterRow>(element.i, element.j), {Parameter{}});
  }
  return out;
}

}  // namespace linkwork
