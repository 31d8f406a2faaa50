(* T3 and T3-sharp of THEORY.md: bounds on ratio and area bound the circumradius. *)
From Pardel Require Import Plane QuarticBound.

(* The circumradius over the shortest edge. *)
Definition ratio (a b c : point) (r : R) : R := r / shortest_edge a b c.

Definition two_edges_are_shortest (a b c : point) : Prop :=
  let e := shortest_edge a b c in
  (distance a b = e /\ distance b c = e) \/ (distance b c = e /\ distance c a = e) \/
  (distance c a = e /\ distance a b = e).

Lemma shortest_edge_turned : forall a b c, shortest_edge b c a = shortest_edge a b c.
Proof. intros; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra. Qed.

Lemma circumcircle_turned : forall a b c o r, circumcircle a b c o r -> circumcircle b c a o r.
Proof. intros a b c o r (A & B & C); repeat split; assumption. Qed.

Lemma two_edges_are_shortest_turned : forall a b c, two_edges_are_shortest b c a <-> two_edges_are_shortest a b c.
Proof. intros; unfold two_edges_are_shortest; rewrite shortest_edge_turned; tauto. Qed.

(* The theorems if ab is a shortest edge. *)
Section OneTriangle.
  Variables a b c o : point.
  Variables r rho delta : R.
  Hypothesis is_triangle : triangle a b c.
  Hypothesis is_circumcircle : circumcircle a b c o r.
  Hypothesis rho_bounds : ratio a b c r <= rho.
  Hypothesis delta_bounds : area a b c <= delta.
  Hypothesis ab_shortest : shortest_edge a b c = distance a b.

  Let S := square_distance a b.
  Let T := square_distance b c.
  Let U := square_distance c a.
  Let k := twice_area a b c.

  Lemma given : 0 < S /\ (S <= T /\ S <= U) /\
    4 * k ^ 2 = 2 * S * T + 2 * T * U + 2 * U * S - S ^ 2 - T ^ 2 - U ^ 2 /\ 0 < k /\
    4 * r ^ 2 * k ^ 2 = S * T * U /\ 0 <= r /\ 0 <= rho /\ r ^ 2 <= rho ^ 2 * S /\ k / 2 <= delta /\
    (r ^ 2 = rho ^ 2 * S <-> ratio a b c r = rho).
  Proof.
    assert (P : 0 < S) by (apply (edge_of_triangle_positive a b c); unfold triangle in is_triangle; lra).
    assert (D := distance_positive a b P).
    assert (N : 0 <= r) by (apply (radius_nonnegative o r a), is_circumcircle).
    assert (M := distance_squared a b); fold S in M.
    unfold ratio in *; rewrite ab_shortest in *.
    assert (Q : 0 <= r / distance a b) by (apply Rmult_le_pos; [assumption|left; now apply Rinv_0_lt_compat]).
    assert (E : r = r / distance a b * distance a b) by (field; lra).
    split; [assumption|]; split.
    { rewrite <- M; unfold T, U; rewrite <- !distance_squared.
      assert (B := distance_nonnegative b c); assert (C := distance_nonnegative c a).
      assert (distance a b <= distance b c /\ distance a b <= distance c a)
        by (rewrite <- ab_shortest; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra).
      split; nra. }
    split; [unfold k, S, T, U, twice_area, square_distance; ring|].
    split; [exact is_triangle|].
    split; [apply (circumradius_formula a b c o r is_circumcircle)|].
    split; [assumption|]. split; [lra|].
    split; [|split; [exact delta_bounds|]].
    - rewrite E, <- M, Rpow_mult_distr.
      apply Rmult_le_compat_r; [apply pow2_ge_0|]. apply pow_incr; lra.
    - rewrite <- M; split; intro H.
      + apply equal_of_squares; [assumption|lra|].
        apply Rmult_eq_reg_r with (distance a b ^ 2); [|apply Rgt_not_eq, pow_lt; assumption].
        rewrite <- Rpow_mult_distr, <- E; exact H.
      + rewrite E, H; ring.
  Qed.

  Lemma isosceles_here : (T = S \/ U = S) <-> two_edges_are_shortest a b c.
  Proof.
    destruct given as (P & (L1 & L2) & _).
    unfold two_edges_are_shortest; rewrite ab_shortest.
    assert (A := distance_squared a b); assert (B := distance_squared b c); assert (C := distance_squared c a).
    fold S in A; fold T in B; fold U in C.
    assert (A0 := distance_nonnegative a b); assert (B0 := distance_nonnegative b c).
    assert (C0 := distance_nonnegative c a).
    split.
    - intros [E|E]; [left|right; right]; split; try reflexivity; apply equal_of_squares; lra.
    - intros [(_ & E)|[(E & F)|(E & _)]].
      + left; rewrite <- A, <- B, E; reflexivity.
      + left; rewrite <- A, <- B, E; reflexivity.
      + right; rewrite <- A, <- C, E; reflexivity.
  Qed.

  Lemma conclusion :
    r <= 2 * Rpower rho (3 / 2) * sqrt delta /\ 1 / 3 <= rho ^ 2 /\ r <= sharp_bound rho delta /\
    (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
  Proof.
    destruct given as (G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9 & G10).
    split; [now apply (weak_bound_holds S T U k)|]. split; [now apply (rho_at_least S T U k r)|].
    split; [now apply (sharp_bound_holds S T U k)|].
    rewrite (sharp_bound_equal S T U k r rho delta) by assumption.
    rewrite G10, isosceles_here; unfold area; fold k; tauto.
  Qed.
End OneTriangle.

Lemma conclusion_of_triangle : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= 2 * Rpower rho (3 / 2) * sqrt delta /\ 1 / 3 <= rho ^ 2 /\ r <= sharp_bound rho delta /\
  (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
Proof.
  intros a b c o r rho delta H K L M.
  assert (H1 := H); unfold triangle in H1; rewrite <- twice_area_turned in H1.
  assert (H2 := H1); rewrite <- twice_area_turned in H2.
  assert (K1 := circumcircle_turned _ _ _ _ _ K); assert (K2 := circumcircle_turned _ _ _ _ _ K1).
  assert (L1 := L); unfold ratio in L1; rewrite <- shortest_edge_turned in L1.
  assert (L2 := L1); rewrite <- shortest_edge_turned in L2.
  assert (M1 := M); unfold area in M1; rewrite <- twice_area_turned in M1.
  assert (M2 := M1); rewrite <- twice_area_turned in M2.
  destruct (Req_dec (shortest_edge a b c) (distance a b)) as [E|E]; [now apply (conclusion a b c o)|].
  destruct (Req_dec (shortest_edge a b c) (distance b c)) as [F|F].
  { rewrite <- shortest_edge_turned in F.
    assert (C := conclusion b c a o r rho delta H1 K1 L1 M1 F).
    rewrite two_edges_are_shortest_turned in C.
    unfold ratio, area in *; rewrite shortest_edge_turned, twice_area_turned in C; exact C. }
  assert (G : shortest_edge c a b = distance c a).
  { revert E F; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra. }
  assert (C := conclusion c a b o r rho delta H2 K2 L2 M2 G).
  do 2 rewrite two_edges_are_shortest_turned in C.
  unfold ratio, area in *; do 2 rewrite shortest_edge_turned in C; do 2 rewrite twice_area_turned in C; exact C.
Qed.

(* T3. *)
Theorem T3 : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= 2 * Rpower rho (3 / 2) * sqrt delta.
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: the bound. *)
Theorem T3_sharp : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= sharp_bound rho delta.
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: equality holds if and only if both bounds are attained and the two shorter sides are equal. *)
Theorem T3_sharp_equality : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: no triangle has a ratio below 1 / sqrt 3. *)
Theorem ratio_of_every_triangle : forall a b c o r,
  triangle a b c -> circumcircle a b c o r -> 1 / sqrt 3 <= ratio a b c r.
Proof.
  intros a b c o r H K.
  destruct (conclusion_of_triangle a b c o r _ _ H K (Rle_refl _) (Rle_refl _)) as (_ & L & _).
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (N : 0 <= ratio a b c r).
  { unfold ratio; apply Rmult_le_pos; [apply (radius_nonnegative o r a), K|].
    unfold triangle in H; left; apply Rinv_0_lt_compat; unfold shortest_edge.
    repeat apply Rmin_glb_lt; apply distance_positive; eapply edge_of_triangle_positive; apply Rgt_not_eq;
      [exact H|rewrite twice_area_turned; exact H|rewrite <- twice_area_turned in H; rewrite <- twice_area_turned in H;
       exact H]. }
  apply at_most_of_squares; [assumption|].
  replace ((1 / sqrt 3) ^ 2) with (1 / sqrt 3 ^ 2) by (field; lra); rewrite S2; exact L.
Qed.
