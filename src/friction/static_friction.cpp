#include "friction/static_friction.h"

#include <stdexcept>
#include <utility>

namespace tribolog::friction {

SteadyFriction::SteadyFriction(std::shared_ptr<const DynamicFriction> model)
    : model_(std::move(model)) {
  if (!model_) throw std::invalid_argument("no model");
}

}  // namespace tribolog::friction
