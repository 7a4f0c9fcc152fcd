#pragma once

#include <vector>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/model/model.hpp"

namespace linkwork::block {

/// Ballast of each body, see ballast_kernels.hpp: as much as its own inertia, or what its branches carry in these steps.
/// Rows from `compliant_from` on are those of inerters, which the model need not have.
std::vector<Ballast> ballasts(const Model& model, const std::vector<TreeStep>& steps, int compliant_from);

}  // namespace linkwork::block
