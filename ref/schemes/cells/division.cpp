#include "division.hpp"

namespace pardel::schemes::cells {

void assign(Division& division, Assignment assignment, const Territory& territory,
            const std::function<Point(Index)>& place) {
  division.worker.resize(division.colour.size());
  std::vector<int> next(static_cast<std::size_t>(division.colours), 0);
  for (Index cell = 0; cell < division.colour.size(); ++cell) {
    int& turn = next[static_cast<std::size_t>(division.colour[cell])];
    division.worker[cell] = assignment == Assignment::blocks ? territory.owner(place(cell)) : turn;
    turn = (turn + 1) % territory.workers();
  }
}

}  // namespace pardel::schemes::cells
