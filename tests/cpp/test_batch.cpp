#include <cstring>
#include <memory>

#include "support.hpp"

using namespace support;

namespace {

bool same_bits(const double* a, const double* b, Eigen::Index count) {
  return std::memcmp(a, b, sizeof(double) * static_cast<std::size_t>(count)) == 0;
}

/// Evaluations of a model on every instruction set that this processor has, at a time when drivers move.
std::vector<Evaluation> evaluations(const Model& model) {
  std::vector<Evaluation> out;
  for (int level = 0; level < instruction_set_count(); ++level) {
    const System system(model, instruction_set(level));
    out.push_back(system.make_evaluation());
    system.evaluate(0.3, model.initial_q(), model.initial_v(), system.initial_history(), out.back());
  }
  return out;
}

void check_same(const Model& model) {
  const std::vector<Evaluation> all = evaluations(model);
  for (std::size_t level = 1; level < all.size(); ++level) {
    INFO(std::string(instruction_set(static_cast<int>(level)).name));
    const Evaluation &a = all.front(), &b = all[level];
    CHECK(same_bits(a.Phi.data(), b.Phi.data(), a.Phi.size()));
    CHECK(same_bits(a.Phi_t.data(), b.Phi_t.data(), a.Phi.size()));
    CHECK(same_bits(a.Phi_dot.data(), b.Phi_dot.data(), a.Phi.size()));
    CHECK(same_bits(a.gamma.data(), b.gamma.data(), a.Phi.size()));
    CHECK(same_bits(a.D.data(), b.D.data(), static_cast<Eigen::Index>(a.D.size())));
    CHECK(same_bits(a.g.data(), b.g.data(), 6 * static_cast<Eigen::Index>(model.bodies().size())));
    CHECK(same_bits(&a.potential, &b.potential, 1));
  }
}

}  // namespace

TEST_CASE("every instruction set gives the same equations of motion to the last bit") {
  for (const JointKind& kind : joint_kinds()) {
    INFO(kind.info.name);
    for (const int bodies : {1, 2, 7, 8, 9, 21}) {
      Random random(static_cast<std::uint64_t>(bodies));
      check_same(random_chain(random, bodies, kind.info.name));
    }
  }
  Random random(5);
  check_same(random_tree(random, 100));
}

TEST_CASE("every instruction set gives the same driven joints to the last bit") {
  Random random(6);
  Model model;
  for (int k = 0; k < 11; ++k) {
    const int signal = model.add_signal(harmonic(0.1 + 0.01 * k, 2.0 + k, 0.1 * k, 2.0));
    model.add_body("body" + std::to_string(k), random_body(random));
    model.add_joint("distance", "rod" + std::to_string(k), k - 1, k, random_attachment(random),
                    {Parameter{1.5, k % 3 == 0 ? -1 : signal}});
  }
  check_same(model);
}

TEST_CASE("Phi_dot is D v + Phi_t, whatever the number of joints of a kind") {
  for (const int bodies : {1, 3, 8, 13}) {
    Random random(static_cast<std::uint64_t>(bodies));
    const System system(random_tree(random, bodies));
    const Evaluation at = evaluate_initially(system);
    const VectorXd expected = dense_D(system, at) * system.model().initial_v() + at.Phi_t;
    CHECK((at.Phi_dot - expected).cwiseAbs().maxCoeff() <= 1e-13 * (1.0 + expected.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("a large model, whose D is written past the caches, has the equations of a small one to the last bit") {
  constexpr int small = 100, large = 75'000;  // revolute joints: 36 MB of D
  const auto evaluate_chain = [](int bodies, int level) {
    Random random(7);
    Model model = random_chain(random, 1, "spherical");  // D of the others begins within a line
    for (int body = 1; body < bodies; ++body) {
      model.add_body("link" + std::to_string(body), random_body(random));
      add_joint(model, random, body % 50 == 0 ? "fixed" : "revolute", "joint" + std::to_string(body), body - 1, body);
    }
    return evaluate_initially(System(model, instruction_set(level)));
  };
  for (int level = sanitized ? instruction_set_count() - 1 : 0; level < instruction_set_count(); ++level) {
    INFO(std::string(instruction_set(level).name));
    const Evaluation a = evaluate_chain(small, level), b = evaluate_chain(large, level);
    CHECK(same_bits(a.D.data(), b.D.data(), 12 * a.Phi.size()));
    for (const auto rows : {&Evaluation::Phi, &Evaluation::Phi_dot, &Evaluation::gamma})
      CHECK(same_bits((a.*rows).data(), (b.*rows).data(), a.Phi.size()));
  }
}

TEST_CASE("a part that all attachments have in common is held once, the others for each joint") {
  constexpr int width = 4, joints = 10, padded = 12;
  Random random(8);
  std::vector<Attachment<double>> all(joints, random_attachment(random));
  for (int k = 0; k < joints; ++k) all[k].s_j[1] = 0.1 * k;
  all[0].s_i[0] = 7.0;  // the first is another one
  all[9].C_j(2, 2) = 8.0;
  JointBatch batch;
  batch.reserve(joints, 0, width);
  for (int k = 0; k < joints; ++k) {
    batch.append(k, k - 1, k, nullptr, 0);
    batch.attach(all[k]);
    batch.row.push_back(5 * k);
    batch.D.push_back(60 * k);
  }
  batch.fill_up();
  const AttachmentPart* parts = batch.joints().attachment;
  for (int k = 0; k < padded; ++k) {
    const Attachment<double>& at = all[std::min(k, joints - 1)];
    const double* numbers[] = {at.s_i.data(), at.s_j.data(), at.C_i.data(), at.C_j.data()};
    for (int part = 0; part < 4; ++part)
      for (int c = 0; c < attachment_parts[part]; ++c)
        CHECK(parts[part].from[parts[part].step * (k - k % width) + c * width + k % width] == numbers[part][c]);
  }
  const std::vector<std::ptrdiff_t> steps = {parts[0].step, parts[1].step, parts[2].step, parts[3].step};
  CHECK(steps == std::vector<std::ptrdiff_t>{3, 3, 0, 9});
}

TEST_CASE("What every processor has is left when the last that asked for it is gone, in whatever order") {
  const int widest = best_instruction_set().level;
  auto first = std::make_unique<OnePath>(), second = std::make_unique<OnePath>();
  const OnePath none(false);
  CHECK(best_instruction_set().level == 0);
  first.reset();
  CHECK(best_instruction_set().level == 0);
  second.reset();
  CHECK(best_instruction_set().level == widest);
}
