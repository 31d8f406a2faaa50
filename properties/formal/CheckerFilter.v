(* What the filters of properties/checker/arithmetic/filter.hpp compute of two sides of a triangle, with its error. The
   coordinates are any finite doubles. *)
From Pardel Require Import Rounding Constants.

Definition eta : R := two_to (-1075).

Lemma eta_value : 0 < eta /\ 1000000 * eta <= u * / 2 ^ 604.
Proof. unfold eta, u, two_to; simpl; split; lra. Qed.

Lemma rnd_monotone : forall v w, v <= w -> rnd v <= rnd w.
Proof. intros; apply round_le; auto with typeclass_instances. Qed.

Lemma below_before_rounding : forall v w, rnd v < rnd w -> v < w.
Proof. intros v w H; destruct (Rlt_or_le v w) as [|L]; [assumption|apply rnd_monotone in L; lra]. Qed.

Lemma rnd_of_double : forall v, is_double v -> rnd v = v.
Proof. intros; apply round_generic; auto with typeclass_instances. Qed.

(* A product that is rounded, also if it is subnormal. *)
Lemma close_any_product : forall c d k m n v' v w' w, 0 <= c -> 0 <= d ->
  c + d + c * d + u * (1 + (c + d + c * d)) <= k -> close c m v' v -> close d n w' w ->
  Rabs (v * w) <= m * n /\ Rabs (rnd (v' * w') - v * w) <= k * (m * n) + eta.
Proof.
  intros c d k m n v' v w' w C D K A B.
  assert (P := close_exact_product c d m n v' v w' w C D A B).
  assert (Q := close_bound _ _ _ _ P); destruct P as [P1 P2]; split; [assumption|].
  assert (E := rnd_any_error (v' * w')); fold eta in E; assert (U := u_value).
  assert (N := Rabs_pos (v * w)).
  replace (rnd (v' * w') - v * w) with (rnd (v' * w') - v' * w' + (v' * w' - v * w)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (u * Rabs (v' * w') <= u * ((1 + (c + d + c * d)) * (m * n))) by (apply Rmult_le_compat_l; lra).
  assert ((c + d + c * d + u * (1 + (c + d + c * d))) * (m * n) <= k * (m * n)) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(* The rounded difference of two coordinates. *)
Definition difference_of (v' v : R) : Prop := exists p q, is_double p /\ is_double q /\ v' = rnd (p - q) /\ v = p - q.

Lemma difference_close : forall v' v, difference_of v' v -> is_double v' /\ close u (Rabs v) v' v.
Proof.
  intros v' v (p & q & P & Q & -> & ->); split; [apply rnd_is_double|]; split; [apply Rle_refl|].
  apply rnd_sum_error; [assumption|now apply opposite_is_double].
Qed.

(* The rounded sum of two products of differences has an error below 4.02 u times the sum of their absolute values. *)
Lemma two_products : forall a' a b' b c' c d' d, difference_of a' a -> difference_of b' b -> difference_of c' c ->
  difference_of d' d ->
  Rabs (rnd (rnd (a' * b') + rnd (c' * d')) - (a * b + c * d))
    <= 402 / 100 * u * (Rabs a * Rabs b + Rabs c * Rabs d) + 3 * eta.
Proof.
  intros a' a b' b c' c d' d A B C D; assert (U := u_value); assert (H := eta_value).
  destruct (close_any_product u u (301 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(unfold u; lra)
              (proj2 (difference_close _ _ A)) (proj2 (difference_close _ _ B))) as [P1 P2].
  destruct (close_any_product u u (301 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(unfold u; lra)
              (proj2 (difference_close _ _ C)) (proj2 (difference_close _ _ D))) as [Q1 Q2].
  destruct (rnd_sum_error (rnd (a' * b')) (rnd (c' * d'))) as [E _]; try apply rnd_is_double.
  set (p := rnd (a' * b')) in *; set (q := rnd (c' * d')) in *.
  set (m := Rabs a * Rabs b) in *; set (n := Rabs c * Rabs d) in *.
  assert (S : Rabs (p + q - (a * b + c * d)) <= 301 / 100 * u * (m + n) + 2 * eta).
  { replace (p + q - (a * b + c * d)) with (p - a * b + (q - c * d)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (T : Rabs (p + q) <= (1 + 301 / 100 * u) * (m + n) + 2 * eta).
  { replace (p + q) with (p + q - (a * b + c * d) + (a * b + c * d)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    assert (X := Rabs_triang (a * b) (c * d)); lra. }
  replace (rnd (p + q) - (a * b + c * d)) with (rnd (p + q) - (p + q) + (p + q - (a * b + c * d))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (u * Rabs (p + q) <= u * ((1 + 301 / 100 * u) * (m + n) + 2 * eta)) by (apply Rmult_le_compat_l; lra).
  assert (M0 : 0 <= m + n) by (assert (X := Rabs_pos (a * b)); assert (Y := Rabs_pos (c * d)); lra).
  assert ((u * (1 + 301 / 100 * u) + 301 / 100 * u) * (m + n) <= 402 / 100 * u * (m + n))
    by (apply Rmult_le_compat_r; [assumption|unfold u; lra]).
  assert (u * (2 * eta) <= 1 * eta) by (assert (u * eta <= / 2 * eta) by (apply Rmult_le_compat_r; lra); lra).
  lra.
Qed.

Lemma opposite_difference : forall v' v, difference_of v' v -> difference_of (- v') (- v).
Proof.
  intros v' v (p & q & P & Q & -> & ->); exists q, p; repeat split; try assumption; [|ring].
  unfold rnd; rewrite <- round_NE_opp; f_equal; ring.
Qed.

Lemma product_below_squares : forall v w, Rabs v * Rabs w <= (v ^ 2 + w ^ 2) / 2.
Proof.
  intros v w; rewrite <- Rabs_mult; assert (A := pow2_ge_0 (v - w)); assert (B := pow2_ge_0 (v + w)).
  unfold Rabs; destruct Rcase_abs; lra.
Qed.

Lemma square_of_absolute : forall v, Rabs v * Rabs v = v ^ 2.
Proof. intro v; rewrite <- Rabs_mult, Rabs_pos_eq; [ring|]; replace (v * v) with (v ^ 2) by ring; apply pow2_ge_0. Qed.

(* Two vectors, rounded: the cross product, the dot product and the sum of their squared lengths, as the source computes
   them. *)
Section TwoVectors.
  Variables px' px py' py qx' qx qy' qy : R.
  Hypothesis Px : difference_of px' px.
  Hypothesis Py : difference_of py' py.
  Hypothesis Qx : difference_of qx' qx.
  Hypothesis Qy : difference_of qy' qy.

  Definition length2 (v w : R) : R := rnd (rnd (v * v) + rnd (w * w)).
  Definition cross2 (ax ay bx by_ : R) : R := rnd (rnd (ax * by_) - rnd (ay * bx)).
  Definition dot2 (ax ay bx by_ : R) : R := rnd (rnd (ax * bx) + rnd (ay * by_)).
  Let T : R := px ^ 2 + py ^ 2 + (qx ^ 2 + qy ^ 2).

  Lemma T_nonnegative : 0 <= T.
  Proof.
    unfold T; assert (A := pow2_ge_0 px); assert (B := pow2_ge_0 py); assert (C := pow2_ge_0 qx).
    assert (D := pow2_ge_0 qy); lra.
  Qed.

  Lemma cross_error : Rabs (px * qy - py * qx) <= T / 2 /\
    Rabs (cross2 px' py' qx' qy' - (px * qy - py * qx)) <= 402 / 100 * u * (T / 2) + 3 * eta.
  Proof.
    assert (A := product_below_squares px qy); assert (B := product_below_squares py qx); assert (U := u_value).
    split.
    - unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, !Rabs_mult; unfold T; lra.
    - unfold cross2; assert (H := two_products px' px qy' qy (- py') (- py) qx' qx Px Qy (opposite_difference _ _ Py) Qx).
      replace (rnd (- py' * qx')) with (- rnd (py' * qx')) in H
        by (unfold rnd; rewrite <- round_NE_opp; f_equal; ring).
      rewrite Rabs_Ropp in H.
      replace (px * qy + - py * qx) with (px * qy - py * qx) in H by ring.
      apply Rle_trans with (1 := H); apply Rplus_le_compat_r; apply Rmult_le_compat_l; [lra|unfold T; lra].
  Qed.

  Lemma dot_error : Rabs (px * qx + py * qy) <= T / 2 /\
    Rabs (dot2 px' py' qx' qy' - (px * qx + py * qy)) <= 402 / 100 * u * (T / 2) + 3 * eta.
  Proof.
    assert (A := product_below_squares px qx); assert (B := product_below_squares py qy); assert (U := u_value).
    split.
    - apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult; unfold T; lra.
    - unfold dot2; apply Rle_trans with (1 := two_products px' px qx' qx py' py qy' qy Px Qx Py Qy).
      apply Rplus_le_compat_r; apply Rmult_le_compat_l; [lra|unfold T; lra].
  Qed.
End TwoVectors.

Lemma length_error : forall vx' vx vy' vy, difference_of vx' vx -> difference_of vy' vy ->
  Rabs (length2 vx' vy' - (vx ^ 2 + vy ^ 2)) <= 402 / 100 * u * (vx ^ 2 + vy ^ 2) + 3 * eta.
Proof.
  intros vx' vx vy' vy X Y; unfold length2; assert (H := two_products vx' vx vx' vx vy' vy vy' vy X X Y Y).
  rewrite !square_of_absolute in H; replace (vx * vx + vy * vy) with (vx ^ 2 + vy ^ 2) in H by ring; exact H.
Qed.
