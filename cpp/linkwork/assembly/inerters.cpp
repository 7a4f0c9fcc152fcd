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

 private:
  std::vector<int> bodies_;
};

/// 0 of other force elements, and of a Model::without_inertances.
double inertance_of(const Model& model, const Element& force) {
  return force_kinds()[force.kind].inertia ? model.force_parameters()[force.first_parameter].constant : 0.0;
}

}  // namespace

Inerters::Inerters(const Model& model, std::ptrdiff_t D, const InstructionSet& instructions) : D_(D) {
  std::vector<int> count(force_kinds().size(), 0);
  for (std::size_t force = 0; force < model.forces().size(); ++force) {
    const Element& it = model.forces()[force];
    const double inertance = inertance_of(model, it);
    if (inertance == 0.0) continue;
    all_.push_back({it.i, it.j, static_cast<int>(force), inertance});
    count[it.kind] += 1;
  }
  for (std::size_t kind = 0; kind < count.size(); ++kind)
    if (count[kind] > 0)
      compile(model, static_cast<int>(kind), count[kind], instruction_set_for(count[kind], instructions));
}

void Inerters::compile(const Model& model, int kind, int count, const InstructionSet& instructions) {
  Rows rows{force_kinds()[kind].inertia_rows().evaluate[instructions.level], {}};
  rows.batch.reserve(static_cast<std::size_t>(count), 0, instructions.width);
  int row = 0;
  for (const Element& it : model.forces()) {
    if (inertance_of(model, it) == 0.0) continue;
    if (it.kind == kind) {
      rows.batch.append(row, it.i, it.j, nullptr, 0);
      rows.batch.attach(it.at);
      rows.batch.row.push_back(row);
      rows.batch.D.push_back(place(static_cast<std::size_t>(row)));
    }
    row += 1;
  }
  rows.batch.fill_up();
  rows_.push_back(std::move(rows));
}

void Inerters::evaluate(const double* q, const double* v, double* D, double* gamma, double* values,
                        ThreadPool& threads) const {
  constexpr int chunk = 4096;  // a multiple of any width
  const ConstraintArrays out{.Phi = values, .Phi_t = values, .Phi_dot = values, .gamma = gamma, .D = D};
  for (const Rows& rows : rows_)
    threads.in_chunks(static_cast<int>(rows.batch.size()), chunk,
                      [&](int first, int last) { rows.evaluate(rows.batch.joints(first, last), q, v, nullptr, out); });
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
