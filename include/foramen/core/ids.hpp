#pragma once
/// \file
/// Typed indices of mesh elements and arrays indexed by them. The compiler rejects a face id where a vertex
/// id is needed.

#include <compare>
#include <cstddef>
#include <utility>
#include <vector>

namespace foramen {

/// Index of one kind of element. A default-constructed id is invalid (-1).
template <class Tag>
struct Id {
  int index = -1;
  constexpr Id() = default;
  constexpr explicit Id(int i) : index(i) {}
  constexpr bool valid() const { return index >= 0; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;
using HalfedgeId = Id<struct HalfedgeTag>;

/// The ids 0 .. count-1, for range-based loops.
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(int i) : i_(i) {}
    constexpr IdType operator*() const { return IdType(i_); }
    constexpr Iterator& operator++() {
      ++i_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    int i_;
  };
  constexpr explicit IdRange(int count) : count_(count) {}
  constexpr Iterator begin() const { return Iterator(0); }
  constexpr Iterator end() const { return Iterator(count_); }
  constexpr int size() const { return count_; }

 private:
  int count_;
};

/// One value per element, indexed by its id.
template <class IdType, class T>
class IdMap {
 public:
  IdMap() = default;
  explicit IdMap(int count, T value = T()) : values_(count, std::move(value)) {}
  explicit IdMap(std::vector<T> values) : values_(std::move(values)) {}

  typename std::vector<T>::reference operator[](IdType id) { return values_[id.index]; }
  typename std::vector<T>::const_reference operator[](IdType id) const { return values_[id.index]; }
  int size() const { return static_cast<int>(values_.size()); }
  bool empty() const { return values_.empty(); }
  IdRange<IdType> ids() const { return IdRange<IdType>(size()); }
  std::vector<T>& values() { return values_; }
  const std::vector<T>& values() const { return values_; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  friend bool operator==(const IdMap&, const IdMap&) = default;

 private:
  std::vector<T> values_;
};

template <class T>
using VertexMap = IdMap<VertexId, T>;
template <class T>
using EdgeMap = IdMap<EdgeId, T>;
template <class T>
using FaceMap = IdMap<FaceId, T>;
template <class T>
using HalfedgeMap = IdMap<HalfedgeId, T>;

}  // namespace foramen
