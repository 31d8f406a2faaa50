#include "guarded.hpp"

#include <array>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "../../core/raster.hpp"
#include "../../core/support/shortest.hpp"
#include "local_bound.hpp"

namespace pardel::engine {
namespace {

CallbackError callback_error(std::string message) { return {{ErrorKind::usage, std::move(message)}}; }

/// Returns call(). `where` makes the text that names the function in the message.
template <class Call, class Where>
auto guarded_call(const Call& call, const Where& where) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const Error& e) {
    throw CallbackError{e};
  } catch (const std::exception& e) {
    throw callback_error(where() + " threw an exception: " + e.what());
  } catch (...) {
    throw callback_error(where() + " threw an exception that is not a std::exception");
  }
}

UserTest guarded_test(UserTest test) {
  return [test = std::move(test)](const std::array<Point, 3>& corners, double area) {
    return guarded_call([&] { return test(corners, area); },
                        [&] {
                          return "Goal::user_test of the triangle " + shortest(corners[0]) + ", " +
                                 shortest(corners[1]) + ", " + shortest(corners[2]);
                        });
  };
}

}  // namespace

Goal guarded(Goal goal) {
  if (goal.user_test) goal.user_test = guarded_test(std::move(goal.user_test));
  if (goal.before_sizes)
    goal.before_sizes = [before = std::move(goal.before_sizes)](std::span<const Point> places) {
      guarded_call([&] { before(places); }, [] { return std::string("Goal::before_sizes"); });
    };
  if (!goal.size || goal.size.target<OnBackground<PointValues>>() != nullptr ||
      goal.size.target<RasterSize>() != nullptr)
    return goal;
  goal.size = [size = std::move(goal.size)](Point p) {
    const double length = guarded_call([&] { return size(p); }, [&] { return "Goal::size at " + shortest(p); });
    if (!(length > 0))
      throw callback_error("Goal::size returned " + shortest(length) + " at " + shortest(p) +
                           "; it must return a length greater than 0");
    return length;
  };
  return goal;
}

Options guarded(Options options) {
  if (options.progress)
    options.progress = [progress = std::move(options.progress)](const Progress& now) {
      return guarded_call([&] { return progress(now); }, [] { return std::string("Options::progress"); });
    };
  if (options.before_refinement)
    options.before_refinement = [call = std::move(options.before_refinement)](const LeastSize& least) {
      return guarded_call([&] { return call(least); }, [] { return std::string("Options::before_refinement"); });
    };
  if (options.after_sweep)
    options.after_sweep = [after_sweep = std::move(options.after_sweep)](const Mesh& mesh, const Sweep& sweep) {
      return guarded_call([&] { return after_sweep(mesh, sweep); }, [] { return std::string("Options::after_sweep"); });
    };
  return options;
}

Error error_of_exception() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {ErrorKind::resources, "out of memory"};
  } catch (const CallbackError& e) {
    return e.error;
  } catch (const Error& e) {
    return e;
  }
}

}  // namespace pardel::engine
