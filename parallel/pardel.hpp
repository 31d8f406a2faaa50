// Everything public of the libraries pardel::core and pardel::parallel: values, files, validation, repair, the mesher.
// Installed as <pardel/pardel.hpp>. The checker is a component of its own: <pardel/properties/checker/check.hpp>.
#pragma once

#include <pardel/core/digest.hpp>
#include <pardel/core/formats.hpp>
#include <pardel/core/goal.hpp>
#include <pardel/core/mesh.hpp>
#include <pardel/core/neighbours.hpp>
#include <pardel/core/pslg.hpp>
#include <pardel/core/raster.hpp>
#include <pardel/core/result.hpp>
#include <pardel/parallel/gaps.hpp>
#include <pardel/parallel/least_size.hpp>
#include <pardel/parallel/locator.hpp>
#include <pardel/parallel/mesher.hpp>
#include <pardel/parallel/options.hpp>
#include <pardel/parallel/problem.hpp>
#include <pardel/parallel/repair.hpp>
#include <pardel/parallel/report.hpp>
#include <pardel/parallel/sizes.hpp>
#include <pardel/parallel/sweep.hpp>
#include <pardel/parallel/validate.hpp>
#include <pardel/parallel/warnings.hpp>
