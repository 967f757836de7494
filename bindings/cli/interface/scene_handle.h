#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/checked_scene.h"
#include "halfspace/scene.h"
#include "model/model.h"

/// A scene of the C interface: its text, and the texts of the last call.
struct hs_scene {
  halfspace::cli::SceneFile file;
  halfspace::cli::Scene scene;
  bool is_read = false;
  std::string toml, notes, names, report, trouble;
  std::vector<halfspace::cli::Shape> shapes;
  std::string last_error;
};

namespace halfspace::cli {

/// A refused call.
struct Refusal : std::runtime_error {
  Refusal(hs_status status, const std::string& text) : std::runtime_error(text), status(status) {}
  hs_status status;
};

/// Refuses a null argument.
inline void require_given(const void* argument, const char* name) {
  if (!argument) throw Refusal(HS_ERROR_ARGUMENT, std::string(name) + " is NULL");
}

/// Calls the body and converts exceptions into a status and an error text.
template <class Body>
hs_status guarded(hs_scene* scene, Body&& body) noexcept {
  if (!scene) return HS_ERROR_ARGUMENT;
  const auto fail = [&](hs_status status, const std::string& text) -> hs_status {
    try {
      scene->last_error = text;
    } catch (const std::bad_alloc&) {
      return HS_ERROR_OUT_OF_MEMORY;
    }
    return status;
  };
  try {
    body();
    return HS_OK;
  } catch (const Refusal& refusal) {
    return fail(refusal.status, refusal.what());
  } catch (const LibraryError& error) {
    return fail(error.status, error.what());
  } catch (const SceneFault& fault) {
    Faults faults;
    faults.add(fault.place, fault.key, fault.what());
    return fail(HS_ERROR_FORMAT, faults.describe(scene->file.path));
  } catch (const std::invalid_argument& error) {
    return fail(HS_ERROR_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return fail(HS_ERROR_OUT_OF_MEMORY, hs_status_string(HS_ERROR_OUT_OF_MEMORY));
  } catch (const std::runtime_error& error) {  // of files
    return fail(HS_ERROR_STATE, error.what());
  } catch (const std::exception& error) {
    return fail(HS_ERROR_INTERNAL, error.what());
  }
}

/// Refuses a scene with faults.
void require_faultless(const hs_scene& scene, const Faults& faults);

/// Refuses an empty scene, and a missing context.
void require_read(const hs_scene& scene, hs_context* context);

/// Reads a scene that was read before, in a context of the caller.
CheckedScene read_in(hs_context* context, const SceneFile& file);

/// Reads the scene again, in a context of the caller, and makes its blocks.
CheckedScene checked_scene(const hs_scene& scene, hs_context* context);

/// A line for each text.
std::string lines_of(const std::vector<std::string>& texts);

/// Sets the notes on a model that was made from a scene.
void set_notes(hs_scene& scene, CheckedScene& checked, const Model& model);

}  // namespace halfspace::cli
