#include "correspond/register_group.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/parallel.hpp"
#include "correspond/feature_targets.hpp"
#include "correspond/map_steps.hpp"
#include "correspond/member_archive.hpp"
#include "correspond/member_steps.hpp"
#include "correspond/own_loops.hpp"
#include "correspond/template_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {
namespace {

PreparedTemplate reference_template(const Reference& reference, const RegisterGroupOptions& options,
                                    const RunContext& ctx) {
  const Mesh& mesh = reference.mesh();
  const TorusMap& map = reference.shape_map.map;
  const int vertices = options.mean.vertices;
  return {kept<TemplateSurface>(ctx, StageKey(ctx, "reference's template", mesh, map, vertices),
                                [&] { return remeshed_template(mesh, map, vertices, ctx); }),
          options};
}

// The options that affect the first registration of a member; the others are set to their defaults.
RegisterGroupOptions options_of_first(RegisterGroupOptions options) {
  const RegisterGroupOptions defaults;
  if (options.bending == Bending::cohort) options.bending = Bending::smooth;  // nothing has been learnt yet
  options.cohort = defaults.cohort;
  options.again = defaults.again;
  options.round_limit = defaults.round_limit;
  options.still_mm = defaults.still_mm;
  options.description_rounds = defaults.description_rounds;
  options.description = defaults.description;
  options.mean.grid_points = defaults.mean.grid_points;
  return options;
}

// The options that affect a later registration, to a given template.
RegisterGroupOptions options_of_later(RegisterGroupOptions options) {
  const RegisterGroupOptions defaults;
  options.initial_map = defaults.initial_map;
  options.edge_cost = defaults.edge_cost;
  options.first = defaults.first;
  options.mean = defaults.mean;
  options.round_limit = defaults.round_limit;
  options.still_mm = defaults.still_mm;
  options.description_rounds = defaults.description_rounds;
  return options;
}

// The data of a round that decreases the description length.
struct GroupDescription {
  double length = 0;
  std::vector<SimilarityTransform> transforms;  // per member: maps its coordinates to those of the mean
  std::vector<std::vector<Vec3>> attractors;    // per member, see DescriptionLength
};

template <class Archive>
void transfer(Archive& archive, MaybeConst<GroupDescription> auto& description) {
  archive(description.length, description.transforms, description.attractors);
}

// The mean of fewer shapes is hardly closer to a further shape than the reference is.
constexpr std::size_t fewest_for_a_mean = 3;

class GroupRegistrar {
 public:
  GroupRegistrar(const std::vector<Mesh>& shapes, const Reference& reference, int reference_index,
                 const RunContext& ctx, const RegisterGroupOptions& options)
      : reference_(reference),
        reference_index_(reference_index),
        ctx_(ctx),
        options_(options),
        steps_(reference, ctx, options),
        members_(shapes.size()) {
    for (std::size_t i = 0; i < shapes.size(); ++i) members_[i].input = &shapes[i];
    result_.members.resize(shapes.size());
  }

  GroupRegistration run() {
    const PreparedTemplate first = reference_template(reference_, options_, ctx_);
    for_each_member("simplify", [&](int i) {
      Member& member = members_[i];
      const StageKey key(ctx_, "working mesh", *member.input, options_.working_vertices);
      member.working = kept<WorkingMesh>(ctx_, key, [&] { return steps_.simplified(*member.input); });
      member.made_from = key;
    });
    const StageKey to_reference(ctx_, "group's reference", reference_, options_of_first(options_));
    advance_each_member("register", to_reference, [&](int i) {
      Member& member = members_[i];
      steps_.begin(member, alignment_of(i), first);
    });
    register_failed_to_mean();
    const PreparedTemplate* last = &first;
    StageKey to_last(ctx_, "group's template", to_reference, options_of_later(options_));
    std::unique_ptr<PreparedTemplate> mean;
    GroupTemplate& group = result_.last_template;
    // In the first round the prior comes from maps that were computed without it, so a second round is always
    // made.
    const int least_rounds = options_.bending == Bending::cohort ? 2 : 1;
    for (int round = 0; round < options_.round_limit; ++round) {
      auto [to_mean, next] = next_mean();
      if (round > 0) result_.template_motion_mm.push_back(distance_of_means(group.grid, next.grid));
      // If the mean has converged, the rounds end before it replaces the template, because the bent shapes
      // are still in the coordinates of the old template.
      if (round >= least_rounds && result_.template_motion_mm.back() < options_.still_mm) break;
      take_transforms(next.transforms);
      next.surface.curvatures = curvature_features(next.surface.mesh, options_.features);
      mean = std::make_unique<PreparedTemplate>(next.surface, options_);
      last = mean.get();
      group = {round + 1, std::move(next.surface), std::move(next.grid), {}};
      are_placed_ = false;
      if (options_.bending == Bending::cohort) learn_priors(to_mean, *mean);
      group.prior = priors_.of_newcomer();
      to_last = StageKey(ctx_, "group's template", to_mean, all_made_from(), options_of_later(options_));
      advance_each_member("round " + std::to_string(round + 1), to_last, [&](int i) {
        Member& member = members_[i];
        if (!are_placed_) steps_.place(member, *mean);
        steps_.again(member, *mean, priors_.of_member(member.place_in_priors));
      });
    }
    for (int round = 0; round < options_.description_rounds; ++round) {
      const StageKey described = describe(to_last, *last);
      advance_each_member("describe " + std::to_string(round + 1), described, [&](int i) {
        Member& member = members_[i];
        steps_.improve(member, transformed(member.working.mesh, member.to_template), *last);
      });
    }
    const StageKey finished = options_.description_rounds > 0 ? describe(to_last, *last) : to_last;
    advance_each_member("finish", finished, [&](int i) { steps_.finish(members_[i], *last); });
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (result_.members[i].failure.text.empty())
        result_.members[i].registered = std::move(members_[i].result);
    return std::move(result_);
  }

 private:
  // Each shape is processed on one thread, because nested parallel loops would not be faster.
  void for_each_member(const std::string& stage, const std::function<void(int)>& body) {
    std::atomic<int> done{0};
    parallel_for(static_cast<int>(members_.size()), ctx_, [&](int i) {
      GroupMember& member = result_.members[i];
      if (!member.failure.text.empty()) return;
      const auto start = std::chrono::steady_clock::now();
      try {
        body(i);
      } catch (const Cancelled&) {
        throw;
      } catch (const std::exception& e) {  // a defect of foramen must not affect the other shapes either
        member.failure = message_of(e);
      }
      member.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const int finished = ++done;
      ctx_.step(stage, static_cast<double>(finished) / static_cast<double>(members_.size()),
                "shape " + std::to_string(finished) + " of " + std::to_string(members_.size()));
    });
  }

  // The same for a step that changes the members. The state of each member after the step is read from the
  // store if it is there, and stored otherwise.
  // \param to  key of the inputs of the step other than the member
  void advance_each_member(const std::string& stage, const StageKey& to,
                           const std::function<void(int)>& step) {
    for_each_member(stage, [&](int i) { advance(i, stage, to, step); });
  }

  void advance(int i, const std::string& stage, const StageKey& to, const std::function<void(int)>& step) {
    Member& member = members_[i];
    MemberState& state = member;
    member.made_from =
        StageKey(ctx_, stage.substr(0, stage.find(' ')), member.made_from, to, i == reference_index_);
    state = kept<MemberState>(ctx_, member.made_from, [&] {
      step(i);
      return std::move(state);
    });
  }

  // Registers the shapes that could not be registered to the reference to the mean of the others, which is
  // closer to most shapes than the reference is. A shape that fails again keeps its first reason.
  void register_failed_to_mean() {
    std::vector<Message> reasons(members_.size());
    for (std::size_t i = 0; i < members_.size(); ++i) reasons[i] = result_.members[i].failure;
    const auto has_failed = [&](std::size_t i) { return !reasons[i].text.empty(); };
    if (has_failed(reference_index_) || present().size() == members_.size() ||
        present().size() < fewest_for_a_mean)
      return;
    const auto [to_mean, next] = next_mean();
    take_transforms(next.transforms);
    DisplacementPrior prior;
    if (options_.bending == Bending::cohort)
      prior = priors_from(to_mean, PreparedTemplate(next.surface, options_)).of_newcomer();
    const RigidTransform mean_to_reference = members_[reference_index_].to_template.inverse();
    const OwnLoops own = with_own_loops(next.surface, ctx_);
    const PreparedTemplate to({next.surface.mesh, own.reference.shape_map.map}, options_);
    const MemberSteps steps(own.reference, ctx_, options_);
    const StageKey key(ctx_, "group's first mean", to_mean, all_made_from(), options_of_first(options_));
    for (std::size_t i = 0; i < members_.size(); ++i) result_.members[i].failure = {};
    for_each_member("register to the mean", [&](int i) {
      if (!has_failed(i)) return;
      static_cast<MemberState&>(members_[i]) = {};
      advance(i, "register", key, [&](int k) {
        Member& member = members_[k];
        steps.begin(member, align(*member.input, to.surface.mesh, ctx_.with_threads(1)), to, prior);
        member.map.map = in_basis_of(std::move(member.map.map), own, reference_.shape_map.map);
        member.result.alignment.transform = mean_to_reference * member.to_template;
      });
    });
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (!result_.members[i].failure.text.empty()) result_.members[i].failure = reasons[i];
  }

  // The keys of all members that have not failed.
  std::vector<StageKey> all_made_from() {
    std::vector<StageKey> keys;
    for (const Member* member : present()) keys.push_back(member->made_from);
    return keys;
  }

  Alignment alignment_of(int i) const {
    if (i != reference_index_) return align(*members_[i].input, reference_.mesh(), ctx_.with_threads(1));
    Alignment identity;
    identity.converged = true;
    return identity;
  }

  struct MemberFailed {};

  // A result that depends on all members: read from the store, or computed and stored. If a member fails
  // meanwhile, the result is computed again from the others, under the key of these inputs.
  template <class Result>
  std::pair<StageKey, Result> together(const std::function<StageKey()>& key_of_present,
                                       const std::function<Result()>& work) {
    while (true) {
      ctx_.check();
      const StageKey key = key_of_present();
      const std::size_t members = present().size();
      try {
        return {key, kept<Result>(ctx_, key, [&] {
                  Result result = work();
                  if (present().size() < members) throw MemberFailed();
                  return result;
                })};
      } catch (const MemberFailed&) {
        continue;
      }
    }
  }

  std::pair<StageKey, MeanTemplate> next_mean() {
    const auto key = [&] { return StageKey(ctx_, "group's mean", all_made_from(), options_.mean); };
    return together<MeanTemplate>(key, [&] {
      std::vector<std::unique_ptr<TorusLocator>> locators(members_.size());
      for_each_member("mean", [&](int i) {
        const std::size_t k = i;
        locators[k] = std::make_unique<TorusLocator>(members_[k].working.mesh, members_[k].map.map);
      });
      std::vector<const TorusLocator*> of_present;
      for (const auto& locator : locators)
        if (locator) of_present.push_back(locator.get());
      return mean_template(of_present, reference_.shape_map.map.lattice, ctx_, options_.mean);
    });
  }

  std::vector<Member*> present() {
    std::vector<Member*> in;
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (result_.members[i].failure.text.empty()) in.push_back(&members_[i]);
    return in;
  }

  void take_transforms(const std::vector<SimilarityTransform>& transforms) {
    const std::vector<Member*> members = present();
    for (std::size_t k = 0; k < members.size(); ++k) members[k]->to_template = rigid(transforms[k]);
  }

  // Computes the priors of all members that have not failed from each other. If the priors are read from the
  // store, the members need not be placed for them; each member is placed in its next step.
  CohortPriors priors_from(const StageKey& to_mean, const PreparedTemplate& to) {
    const auto key = [&] {
      return StageKey(ctx_, "group's priors", to_mean, all_made_from(), options_.displacements,
                      options_.cohort);
    };
    auto made = together<CohortPriors>(key, [&] {
      for_each_member("place", [&](int i) { steps_.place(members_[i], to); });
      are_placed_ = true;
      std::vector<std::vector<Vec3>> placed;
      for (const Member* member : present()) placed.push_back(member->bent);
      return cohort_priors(to.surface.mesh, to.displacements, placed, options_.cohort);
    });
    return std::move(made.second);
  }

  void learn_priors(const StageKey& to_mean, const PreparedTemplate& to) {
    priors_ = priors_from(to_mean, to);
    int place = 0;
    for (Member* member : present()) member->place_in_priors = place++;
    result_.unexplained_shares.push_back(priors_.unexplained_share);
  }

  // Computes the attractors that decrease the description length of the cohort for the present maps.
  StageKey describe(const StageKey& to_template, const PreparedTemplate& to) {
    const auto key = [&] { return StageKey(ctx_, "group's description", to_template, all_made_from()); };
    auto [described, description] =
        together<GroupDescription>(key, [&] { return description_of_present(to); });
    result_.description_lengths.push_back(description.length);
    take_transforms(description.transforms);
    const std::vector<Member*> members = present();
    for (std::size_t k = 0; k < members.size(); ++k)
      members[k]->attractor = std::move(description.attractors[k]);
    return described;
  }

  GroupDescription description_of_present(const PreparedTemplate& to) {
    std::vector<std::vector<Vec3>> lifted;
    for (const Member* member : present()) {
      const TorusLocator locator(member->working.mesh, member->map.map);
      lifted.push_back(lift_to_surface(locator, to.surface.map.turns.values()));
    }
    const std::vector<double> areas = vertex_areas(to.surface.mesh).values();
    ProcrustesResult aligned = procrustes(lifted, ScaleMode::keep, areas);
    DescriptionLength length = description_length(aligned.aligned, areas, options_.description);
    return {length.value, std::move(aligned.transforms), std::move(length.attractors)};
  }

  static double distance_of_means(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
    const SimilarityTransform motion = fit_similarity(after, before, ScaleMode::keep);
    double squares = 0;
    for (std::size_t k = 0; k < before.size(); ++k) squares += (motion(after[k]) - before[k]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(before.size()));
  }

  const Reference& reference_;
  int reference_index_;
  RunContext ctx_;
  const RegisterGroupOptions& options_;
  MemberSteps steps_;
  std::vector<Member> members_;
  CohortPriors priors_;      // the priors of the present round; without Bending::cohort the smooth process
  bool are_placed_ = false;  // whether the members have the vertices of the present mean
  GroupRegistration result_;
};

}  // namespace

GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options) {
  FORAMEN_ASSERT(reference_index >= 0 && reference_index < static_cast<int>(shapes.size()));
  return GroupRegistrar(shapes, reference, reference_index, ctx, options).run();
}

RegisteredShape register_to_group(const Mesh& shape, const Reference& reference, const GroupTemplate& group,
                                  const RunContext& ctx, const RegisterGroupOptions& options) {
  if (options.description_rounds > 0)
    throw InvalidInput(
        "a shape cannot be registered to a group that was made with description_rounds > 0: their targets "
        "are those of the group's own shapes");
  require_genus_one(shape);
  const RunContext single = ctx.with_threads(1);
  const MemberSteps steps(reference, single, options);
  Member member;
  member.input = &shape;
  member.working = steps.simplified(shape);
  const PreparedTemplate first = reference_template(reference, options, single);
  steps.begin(member, align(shape, reference.mesh(), single), first);
  if (group.rounds == 0) {
    steps.finish(member, first);
    return std::move(member.result);
  }
  const PreparedTemplate mean(group.surface, options);
  const TorusGrid grid = make_torus_grid(reference.shape_map.map.lattice, options.mean.grid_points);
  for (int round = 0; round < group.rounds; ++round) {
    steps.newcomer_round(member, grid.turns, group.grid, mean, group.prior);
  }
  steps.finish(member, mean);
  return std::move(member.result);
}

}  // namespace foramen
