#pragma once
// One input or output of a model function, and how its C++ member is read, checked and written.
//
// The description of a function lists its fields with a pointer to the member each stands for. Everything
// else (JSON, command line, error messages, generated pages, tests) works from that list through Access.

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "models/catalogue/error.h"
#include "models/catalogue/range.h"
#include "models/catalogue/value.h"

namespace verstat::models {

/// Names of an enumeration as users write them: specialise with
/// `static constexpr std::array names{std::pair{LifeLaw::weibull, "weibull"}, ...};`
template <class E>
struct EnumNames;

struct Field;

/// The shape of a value, for schemas, forms and generated pages.
struct TypeInfo {
  enum class Kind { number, integer, flag, text, choice, list, structure, alternatives };
  Kind kind = Kind::number;
  bool nullable = false;
  std::vector<std::string> choices = {};       ///< of a choice
  std::vector<TypeInfo> element = {};          ///< of a list: exactly one
  const std::vector<Field>* fields = nullptr;  ///< of a structure
  /// of alternatives: value of "kind" and the members that go with it
  std::vector<std::pair<std::string, const std::vector<Field>*>> alternatives = {};
  /// "number", "list of number", "one of "weibull", "normal"", ...
  [[nodiscard]] std::string text() const;
};

/// The members of a structure that is itself an input or output (a cam, a band). Specialise with
/// `static std::vector<Field> fields();`, built from `member(...)` below.
template <class S>
struct StructFields;

template <class S>
concept DescribedStruct = requires {
  {StructFields<S>::fields()};
};

/// How one member of a struct is read from and written to a Value. `object` is the struct.
class Access {
 public:
  Access() = default;
  Access(const Access&) = delete;
  Access& operator=(const Access&) = delete;
  virtual ~Access() = default;
  virtual void read(void* object, const Value& value, const Field& field) const = 0;
  [[nodiscard]] virtual Value write(const void* object) const = 0;
  /// Throws DomainError when the member is outside the field's range.
  virtual void check(const void* object, const Field& field) const = 0;
  /// True when no NaN or infinity is in it.
  [[nodiscard]] virtual bool finite(const void* object) const = 0;
  /// Address of the number that `path` (member names and list indices) leads to from here; null when it leads
  /// elsewhere. An optimizer that moves one number a thousand times must not go through text.
  [[nodiscard]] virtual double* locate(void* object, std::span<const std::string> path) const = 0;
  [[nodiscard]] virtual TypeInfo type_info() const = 0;
  [[nodiscard]] std::string type() const { return type_info().text(); }
};

struct Field {
  std::string name;     ///< as in the card and in JSON
  std::string symbol;   ///< as in the paper: "R_z"
  std::string unit;     ///< "m/min"; "1" for numbers without a unit, "-" for texts and flags
  Range range;          ///< of a number, or of each number of a list
  std::string meaning;  ///< one line
  bool required = true;
  Value default_value;         ///< when not required
  Value example;               ///< a value inside the range; the default when none is given
  std::size_t min_length = 0;  ///< of a list
  std::size_t max_length = 100'000;
  std::shared_ptr<const Access> access;

  [[nodiscard]] std::string allowed() const;  ///< "0 < r_tooth < 1 (reliability of one tooth)"
};

/// Reads the members of a described struct from a map. Unknown, missing and ill-typed members are
/// DomainErrors whose input() is the path of the culprit ("cam/r_base_mm").
void read_fields(void* object, const std::vector<Field>& fields, const Value& value);
/// Throws DomainError for the first member outside its range.
void check_fields(const void* object, const std::vector<Field>& fields);
[[nodiscard]] double* locate_in_fields(void* object, const std::vector<Field>& fields,
                                       std::span<const std::string> path);
[[nodiscard]] Value write_fields(const void* object, const std::vector<Field>& fields);

namespace detail {

[[noreturn]] void wrong_type(const Field& field, const Value& value, std::string_view expected);
[[noreturn]] void out_of_range(const Field& field, const Value& value);
void check_length(const Field& field, std::size_t length);
double read_number(const Field& field, const Value& value);
std::int64_t read_integer(const Field& field, const Value& value, std::int64_t low, std::int64_t high);
[[nodiscard]] Field element_of(const Field& field, std::size_t index);
/// The index a path names, or `size` when it names none.
[[nodiscard]] std::size_t list_index(const std::string& token, std::size_t size);
[[nodiscard]] Value without_kind(const Value& value);
[[noreturn]] void rethrow_within(const Field& field, const DomainError& e);
/// `defaults` null: the field is required.
[[nodiscard]] Field make_field(std::shared_ptr<const Access> access, const void* defaults,
                               std::string_view name, std::string_view symbol, std::string_view unit,
                               const Range& range, std::string_view meaning);

/// Runs `body` on the members of the structure `field`, so that an error names the whole path.
template <class Body>
void within(const Field& field, Body&& body) {
  try {
    body();
  } catch (const DomainError& e) {
    rethrow_within(field, e);
  }
}

template <class T>
struct Binding;

template <>
struct Binding<double> {
  static void read(double& to, const Value& v, const Field& f) { to = read_number(f, v); }
  static Value write(double x) { return x; }
  static void check(double x, const Field& f) {
    if (!f.range.contains(x)) out_of_range(f, x);
  }
  static bool finite(double x) { return std::isfinite(x); }
  static double* locate(double& x, std::span<const std::string> path) { return path.empty() ? &x : nullptr; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::number}; }
};

template <class I>
requires std::integral<I> &&(!std::same_as<I, bool>)struct Binding<I> {
  static void read(I& to, const Value& v, const Field& f) {
    to = static_cast<I>(read_integer(f, v, std::numeric_limits<I>::min(), std::numeric_limits<I>::max()));
  }
  static Value write(I x) { return static_cast<std::int64_t>(x); }
  static void check(I x, const Field& f) {
    if (!f.range.contains(static_cast<double>(x))) out_of_range(f, static_cast<std::int64_t>(x));
  }
  static bool finite(I) { return true; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::integer}; }
};

template <>
struct Binding<bool> {
  static void read(bool& to, const Value& v, const Field& f) {
    if (v.boolean() == nullptr) wrong_type(f, v, "true or false");
    to = *v.boolean();
  }
  static Value write(bool x) { return x; }
  static void check(bool, const Field&) {}
  static bool finite(bool) { return true; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::flag}; }
};

template <>
struct Binding<std::string> {
  static void read(std::string& to, const Value& v, const Field& f) {
    if (v.text() == nullptr) wrong_type(f, v, "a text");
    to = *v.text();
  }
  static Value write(const std::string& x) { return x; }
  static void check(const std::string&, const Field&) {}
  static bool finite(const std::string&) { return true; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::text}; }
};

template <class E>
requires std::is_enum_v<E>
struct Binding<E> {
  static std::string choices() {
    std::string all;
    for (const auto& [e, name] : EnumNames<E>::names)
      all += (all.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    return all;
  }
  static void read(E& to, const Value& v, const Field& f) {
    if (v.text() != nullptr)
      for (const auto& [e, name] : EnumNames<E>::names)
        if (*v.text() == name) {
          to = e;
          return;
        }
    wrong_type(f, v, "one of " + choices());
  }
  static Value write(E x) {
    for (const auto& [e, name] : EnumNames<E>::names)
      if (e == x) return name;
    return {};
  }
  static void check(E x, const Field& f) {
    if (write(x).is_null()) wrong_type(f, static_cast<int>(x), "one of " + choices());
  }
  static bool finite(E) { return true; }
  static TypeInfo type() {
    TypeInfo info{.kind = TypeInfo::Kind::choice};
    for (const auto& [e, name] : EnumNames<E>::names) info.choices.emplace_back(name);
    return info;
  }
};

template <class T>
struct Binding<std::optional<T>> {
  static void read(std::optional<T>& to, const Value& v, const Field& f) {
    if (v.is_null()) {
      to.reset();
      return;
    }
    to.emplace();
    Binding<T>::read(*to, v, f);
  }
  static Value write(const std::optional<T>& x) { return x ? Binding<T>::write(*x) : Value(); }
  static void check(const std::optional<T>& x, const Field& f) {
    if (x) Binding<T>::check(*x, f);
  }
  static bool finite(const std::optional<T>& x) { return !x || Binding<T>::finite(*x); }
  static double* locate(std::optional<T>& x, std::span<const std::string> path) {
    if constexpr (requires(T & t) { Binding<T>::locate(t, path); })
      return x ? Binding<T>::locate(*x, path) : nullptr;
    else
      return nullptr;
  }
  static TypeInfo type() {
    TypeInfo info = Binding<T>::type();
    info.nullable = true;
    return info;
  }
};

template <class T>
struct Binding<std::vector<T>> {
  static void read(std::vector<T>& to, const Value& v, const Field& f) {
    const Value::List* list = v.list();
    if (list == nullptr) wrong_type(f, v, "a list");
    check_length(f, list->size());
    to.clear();
    to.reserve(list->size());
    for (std::size_t k = 0; k < list->size(); ++k) {
      T element{};
      Binding<T>::read(element, (*list)[k], element_of(f, k));
      to.push_back(std::move(element));
    }
  }
  static Value write(const std::vector<T>& x) {
    Value::List list;
    list.reserve(x.size());
    for (const auto& element : x) list.push_back(Binding<T>::write(element));
    return list;
  }
  static void check(const std::vector<T>& x, const Field& f) {
    check_length(f, x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      // The element's name costs a string: built only for the message.
      if constexpr (std::is_arithmetic_v<T>) {
        if (!f.range.contains(static_cast<double>(x[k]))) Binding<T>::check(x[k], element_of(f, k));
      } else {
        Binding<T>::check(x[k], element_of(f, k));
      }
    }
  }
  static bool finite(const std::vector<T>& x) {
    for (const auto& element : x)
      if (!Binding<T>::finite(element)) return false;
    return true;
  }
  static double* locate(std::vector<T>& x, std::span<const std::string> path) {
    if (path.empty()) return nullptr;
    const std::size_t index = list_index(path.front(), x.size());
    if constexpr (requires(T & e) { Binding<T>::locate(e, path); })
      return index < x.size() ? Binding<T>::locate(x[index], path.subspan(1)) : nullptr;
    else
      return nullptr;
  }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::list, .element = {Binding<T>::type()}}; }
};

template <DescribedStruct S>
struct Binding<S> {
  static const std::vector<Field>& fields() {
    static const std::vector<Field> all = StructFields<S>::fields();
    return all;
  }
  static void read(S& to, const Value& v, const Field& f) {
    within(f, [&] { read_fields(&to, fields(), v); });
  }
  static Value write(const S& x) { return write_fields(&x, fields()); }
  static void check(const S& x, const Field& f) {
    within(f, [&] { check_fields(&x, fields()); });
  }
  static bool finite(const S& x) {
    for (const Field& field : fields())
      if (!field.access->finite(&x)) return false;
    return true;
  }
  static double* locate(S& x, std::span<const std::string> path) {
    return locate_in_fields(&x, fields(), path);
  }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::structure, .fields = &fields()}; }
};

/// One of several structures, told apart by the text member "kind" that each names in `kind`.
template <class... S>
struct Binding<std::variant<S...>> {
  using Variant = std::variant<S...>;
  static std::string kinds() {
    std::string all;
    ((all += (all.empty() ? "\"" : ", \"") + std::string(S::kind) + "\""), ...);
    return all;
  }
  static void read(Variant& to, const Value& v, const Field& f) {
    const Value* kind = v.find("kind");
    if (kind == nullptr || kind->text() == nullptr)
      wrong_type(f, v, "an object whose \"kind\" is one of " + kinds());
    const Value rest = without_kind(v);
    const bool known = ((*kind->text() == S::kind ? (read_as<S>(to, rest, f), true) : false) || ...);
    if (!known) wrong_type(f, v, "an object whose \"kind\" is one of " + kinds());
  }
  static Value write(const Variant& x) {
    return std::visit(
        [](const auto& s) {
          Value::Map members{{"kind", Value(std::remove_cvref_t<decltype(s)>::kind)}};
          const Value rest = Binding<std::remove_cvref_t<decltype(s)>>::write(s);
          members.insert(members.end(), rest.map()->begin(), rest.map()->end());
          return Value(std::move(members));
        },
        x);
  }
  static void check(const Variant& x, const Field& f) {
    std::visit([&](const auto& s) { Binding<std::remove_cvref_t<decltype(s)>>::check(s, f); }, x);
  }
  static bool finite(const Variant& x) {
    return std::visit([](const auto& s) { return Binding<std::remove_cvref_t<decltype(s)>>::finite(s); }, x);
  }
  static double* locate(Variant& x, std::span<const std::string> path) {
    return std::visit([&](auto& s) { return Binding<std::remove_cvref_t<decltype(s)>>::locate(s, path); }, x);
  }
  static TypeInfo type() {
    TypeInfo info{.kind = TypeInfo::Kind::alternatives};
    (info.alternatives.emplace_back(S::kind, &Binding<S>::fields()), ...);
    return info;
  }

 private:
  template <class T>
  static void read_as(Variant& to, const Value& rest, const Field& f) {
    T s{};
    Binding<T>::read(s, rest, f);
    to = std::move(s);
  }
};

// By offset rather than by pointer to member: one instance per type of member instead of one per struct and
// member keeps the descriptions of hundreds of functions quick to compile.
template <class T>
class MemberAccess final : public Access {
 public:
  explicit MemberAccess(std::ptrdiff_t offset) : offset_(offset) {}
  void read(void* object, const Value& value, const Field& field) const override {
    Binding<T>::read(*at(object), value, field);
  }
  [[nodiscard]] Value write(const void* object) const override { return Binding<T>::write(*at(object)); }
  void check(const void* object, const Field& field) const override { Binding<T>::check(*at(object), field); }
  [[nodiscard]] bool finite(const void* object) const override { return Binding<T>::finite(*at(object)); }
  [[nodiscard]] double* locate(void* object, std::span<const std::string> path) const override {
    if constexpr (requires(T & x) { Binding<T>::locate(x, path); })
      return Binding<T>::locate(*at(object), path);
    else
      return nullptr;
  }
  [[nodiscard]] TypeInfo type_info() const override { return Binding<T>::type(); }

 private:
  [[nodiscard]] T* at(void* object) const {
    return reinterpret_cast<T*>(static_cast<char*>(object) + offset_);
  }
  [[nodiscard]] const T* at(const void* object) const {
    return reinterpret_cast<const T*>(static_cast<const char*>(object) + offset_);
  }
  std::ptrdiff_t offset_;
};

/// A default-constructed S: holds the defaults, and shows where its members lie.
template <class S>
[[gnu::noinline]] const S& default_object() {
  static const S object{};
  return object;
}

template <class T>
[[gnu::noinline]] Field make_field(std::ptrdiff_t offset, const void* defaults, std::string_view name,
                                   std::string_view symbol, std::string_view unit, const Range& range,
                                   std::string_view meaning) {
  return make_field(std::make_shared<MemberAccess<T>>(offset), defaults, name, symbol, unit, range, meaning);
}

}  // namespace detail

/// A field of struct S. `required` false: the value a default-constructed S holds is the default.
template <class S, class T, class B>
requires std::derived_from<S, B>
[[nodiscard]] Field member(T B::*pointer, std::string_view name, std::string_view symbol,
                           std::string_view unit, const Range& range, std::string_view meaning,
                           bool required = true) {
  const S& object = detail::default_object<S>();
  const std::ptrdiff_t offset =
      reinterpret_cast<const char*>(&(object.*pointer)) - reinterpret_cast<const char*>(&object);
  return detail::make_field<T>(offset, required ? nullptr : &object, name, symbol, unit, range, meaning);
}

}  // namespace verstat::models
