#pragma once
// What the door's types hold, and the way to it for the other files of this room.

#include <memory>
#include <optional>
#include <string>

#include "api/outcome.h"
#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "joint/dataset.h"
#include "render/workers/renderer.h"
#include "tribolog/calibration.h"
#include "tribolog/dataset.h"
#include "tribolog/figures.h"

namespace tribolog {

struct Dataset::Contents {
  std::string manifest;  ///< Its path.
  joint::Dataset dataset;
};

struct Renderer::Processes {
  Processes(int at_once, render::workers::Prepared prepared) : renderer(at_once, prepared) {}
  render::workers::FigureRenderer renderer;
};

}  // namespace tribolog

namespace tribolog::api {

/// What report and figures need besides the outcome.
struct Identified {
  Dataset dataset;
  calibration::Calibration calibration;
  calibration::Provenance provenance;
};

}  // namespace tribolog::api

namespace tribolog {

struct Calibration::Contents {
  api::Outcome outcome;
  std::string json;
  std::shared_ptr<const api::Identified> identified;  ///< Null: it was read from JSON.
};

}  // namespace tribolog

namespace tribolog::api {

struct Inside {
  static const joint::Dataset& of(const Dataset& dataset) { return dataset.contents_->dataset; }
  /// @throw UsageError: it was read from JSON.
  static const Identified& of(const Calibration& calibration);
  static render::workers::FigureRenderer* of(Renderer* renderer);
  static Calibration made(Calibration::Contents contents);
};

}  // namespace tribolog::api
