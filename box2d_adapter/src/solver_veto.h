#pragma once

#include <box2d/b2_world.h>
#include <box2d/b2_world_callbacks.h>

#include <functional>

#include "contact.h"

namespace halfspace::box2d {

/// Excludes pairs of the half-space narrow phase from Box2D's solver and continuous collision: a listener in
/// front of the host's disables their contacts. Touching, manifolds and all events except PostSolve do not
/// change.
class SolverVeto : b2ContactListener {
 public:
  using Excludes = std::function<bool(const b2Contact&)>;

  /// `excludes` chooses among these pairs; empty: all.
  explicit SolverVeto(b2World& world, Excludes excludes = {})
      : world_(world), host_(listener()), excludes_(std::move(excludes)) {
    world.SetContactListener(this);
  }
  ~SolverVeto() override {
    const bool is_replaced = listener() != this;
    if (!is_replaced) world_.SetContactListener(host_);
  }
  SolverVeto(const SolverVeto&) = delete;
  SolverVeto& operator=(const SolverVeto&) = delete;

 private:
  b2ContactListener* listener() const { return world_.GetContactManager().m_contactListener; }

  void BeginContact(b2Contact* contact) override {
    if (host_) host_->BeginContact(contact);
  }
  void EndContact(b2Contact* contact) override {
    if (host_) host_->EndContact(contact);
  }
  /// If the host disables a contact, its pair takes no force or impulse in the next step.
  void PreSolve(b2Contact* contact, const b2Manifold* before) override {
    if (host_) host_->PreSolve(contact, before);
    JudgedPair* pair = judged_pair_of(*contact);
    if (!pair) return;
    pair->let_through = !contact->IsEnabled();
    if (!excludes_ || excludes_(*contact)) contact->SetEnabled(false);
  }
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    if (host_) host_->PostSolve(contact, impulse);
  }

  b2World& world_;
  b2ContactListener* host_;
  Excludes excludes_;
};

}  // namespace halfspace::box2d
