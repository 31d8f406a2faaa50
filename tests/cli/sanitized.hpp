// Is this a build with a sanitizer?
#pragma once

namespace pardel::testing {

/// True for a build with a sanitizer, whose shadow memory exceeds any useful limit on the address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace pardel::testing
