(* Shape, is_tame(), is_not_larger() and is_outside_circle() of properties/checker/arithmetic/filter.hpp: if they answer
   `true`, so does exact arithmetic. *)
From Pardel Require Import Rounding Constants CheckerFilter OutsideCircle.

Section Shape.
  (* The sides of the triangle, rounded and exact. *)
  Variables s0x' s0x s0y' s0y s1x' s1x s1y' s1y s2x' s2x s2y' s2y : R.
  Hypothesis D0x : difference_of s0x' s0x.
  Hypothesis D0y : difference_of s0y' s0y.
  Hypothesis D1x : difference_of s1x' s1x.
  Hypothesis D1y : difference_of s1y' s1y.
  Hypothesis D2x : difference_of s2x' s2x.
  Hypothesis D2y : difference_of s2y' s2y.

  Definition shape_sum : R := rnd (rnd (length2 s0x' s0y' + length2 s1x' s1y') + length2 s2x' s2y').
  Definition shape_doubled_area : R := cross2 s2y' s2x' s1y' s1x'.
  Definition shape_dot_0 : R := - dot2 s1x' s1y' s2x' s2y'.
  Let S : R := s0x ^ 2 + s0y ^ 2 + (s1x ^ 2 + s1y ^ 2) + (s2x ^ 2 + s2y ^ 2).
  Let area : R := s2y * s1x - s2x * s1y.
  Let dot_0 : R := - (s1x * s2x + s1y * s2y).

  Hypothesis large_enough : least_square <= shape_sum.

  (* 2.1 * unit, as computed: constants_are_doubles.g. *)
  Variable factor : R.
  Hypothesis factor_close : Rabs (factor - shape_error) <= u * shape_error.
  Definition shape_error_computed : R := rnd (factor * shape_sum).

  Lemma parts_nonnegative : 0 <= s0x ^ 2 + s0y ^ 2 /\ 0 <= s1x ^ 2 + s1y ^ 2 /\ 0 <= s2x ^ 2 + s2y ^ 2.
  Proof.
    assert (P : forall v w, 0 <= v ^ 2 + w ^ 2)
      by (intros v w; assert (A := pow2_ge_0 v); assert (B := pow2_ge_0 w); lra).
    repeat split; apply P.
  Qed.

  Lemma sum_error : (1 - 604 / 100 * u) * S - 20 * eta <= shape_sum <= (1 + 604 / 100 * u) * S + 20 * eta.
  Proof.
    assert (U := u_value); destruct eta_value as [E0 _]; destruct parts_nonnegative as (P0 & P1 & P2).
    assert (A := below_absolute _ _ _ (length_error _ _ _ _ D0x D0y)).
    assert (B := below_absolute _ _ _ (length_error _ _ _ _ D1x D1y)).
    assert (C := below_absolute _ _ _ (length_error _ _ _ _ D2x D2y)).
    unfold shape_sum; fold S.
    set (a := s0x ^ 2 + s0y ^ 2) in *; set (b := s1x ^ 2 + s1y ^ 2) in *; set (c := s2x ^ 2 + s2y ^ 2) in *.
    destruct (rnd_sum_error (length2 s0x' s0y') (length2 s1x' s1y')) as [F _]; try apply rnd_is_double.
    destruct (rnd_sum_error (rnd (length2 s0x' s0y' + length2 s1x' s1y')) (length2 s2x' s2y')) as [G _];
      try apply rnd_is_double.
    set (v := length2 s0x' s0y') in *; set (w := length2 s1x' s1y') in *; set (z := length2 s2x' s2y') in *.
    assert (Bound : forall t lo hi, lo <= t <= hi -> - hi <= lo -> Rabs t <= hi)
      by (intros t lo hi L M; unfold Rabs; destruct Rcase_abs; lra).
    assert (ua : 0 <= u * a) by (apply Rmult_le_pos; lra); assert (ub : 0 <= u * b) by (apply Rmult_le_pos; lra).
    assert (uc : 0 <= u * c) by (apply Rmult_le_pos; lra).
    assert (Sab : Rabs (v + w) <= (1 + 402 / 100 * u) * (a + b) + 6 * eta)
      by (apply Bound with ((1 - 402 / 100 * u) * (a + b) - 6 * eta); lra).
    apply below_absolute in F.
    assert (K1 : u * Rabs (v + w) <= u * ((1 + 402 / 100 * u) * (a + b) + 6 * eta))
      by (apply Rmult_le_compat_l; lra).
    assert (K2 : u * ((1 + 402 / 100 * u) * (a + b) + 6 * eta) <= 101 / 100 * u * (a + b) + eta).
    { assert (u * (6 * eta) <= eta) by (assert (6 * u * eta <= 1 * eta) by (apply Rmult_le_compat_r; lra); lra).
      assert (u * (1 + 402 / 100 * u) * (a + b) <= 101 / 100 * u * (a + b))
        by (apply Rmult_le_compat_r; [lra|unfold u; lra]). lra. }
    set (x := rnd (v + w)) in *.
    assert (Sx : Rabs (x + z) <= (1 + 503 / 100 * u) * (a + b + c) + 10 * eta)
      by (apply Bound with ((1 - 503 / 100 * u) * (a + b + c) - 10 * eta); lra).
    apply below_absolute in G.
    assert (K3 : u * Rabs (x + z) <= u * ((1 + 503 / 100 * u) * (a + b + c) + 10 * eta))
      by (apply Rmult_le_compat_l; lra).
    assert (K4 : u * ((1 + 503 / 100 * u) * (a + b + c) + 10 * eta) <= 101 / 100 * u * (a + b + c) + eta).
    { assert (u * (10 * eta) <= eta) by (assert (10 * u * eta <= 1 * eta) by (apply Rmult_le_compat_r; lra); lra).
      assert (u * (1 + 503 / 100 * u) * (a + b + c) <= 101 / 100 * u * (a + b + c))
        by (apply Rmult_le_compat_r; [lra|unfold u; lra]). lra. }
    replace S with (a + b + c) by reflexivity; lra.
  Qed.

  Lemma S_large : / 2 ^ 301 <= S /\ 10000 * eta <= u * S.
  Proof.
    assert (U := u_value); destruct eta_value as [E0 E1]; destruct sum_error as [_ H].
    assert (L := large_enough); unfold least_square in L.
    assert (Hs : / 2 ^ 301 <= S).
    { assert (20 * eta <= / 2 ^ 310) by (unfold u in E1; lra).
      assert ((1 + 604 / 100 * u) * S <= (1 + 604 / 100 * u) * S) by lra.
      destruct (Rle_or_lt (/ 2 ^ 301) S) as [|N]; [assumption|exfalso].
      assert ((1 + 604 / 100 * u) * S <= (1 + 604 / 100 * u) * / 2 ^ 301) by (apply Rmult_le_compat_l; lra).
      unfold u in *; lra. }
    split; [assumption|].
    assert (u * / 2 ^ 604 <= u * S) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Lemma error_computed_large : 208 / 100 * u * S <= shape_error_computed.
  Proof.
    assert (U := u_value); destruct S_large as [S0 E]; destruct sum_error as [L _]; destruct eta_value as [E0 _].
    assert (F := below_absolute _ _ _ factor_close); unfold shape_error in F.
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    assert (Fl : 2099 / 1000 * u <= factor) by (unfold u in *; lra).
    assert (Sl : (1 - 605 / 100 * u) * S <= shape_sum) by lra.
    assert (Sp : 0 < (1 - 605 / 100 * u) * S) by (apply Rmult_lt_0_compat; lra).
    assert (M : 2099 / 1000 * u * ((1 - 605 / 100 * u) * S) <= factor * shape_sum)
      by (apply Rmult_le_compat; lra).
    destruct (rnd_bounds (factor * shape_sum)) as [R _]; [apply Rle_trans with (2 := M); apply Rmult_le_pos; lra|].
    fold shape_error_computed in R.
    assert (M2 : (1 - u) * (2099 / 1000 * u * ((1 - 605 / 100 * u) * S)) <= (1 - u) * (factor * shape_sum))
      by (apply Rmult_le_compat_l; lra).
    assert (M3 : 2095 / 1000 * (u * S) <= (1 - u) * (2099 / 1000 * u * ((1 - 605 / 100 * u) * S))).
    { replace ((1 - u) * (2099 / 1000 * u * ((1 - 605 / 100 * u) * S)))
        with ((1 - u) * (2099 / 1000) * (1 - 605 / 100 * u) * (u * S)) by ring.
      apply Rmult_le_compat_r; [lra|unfold u; lra]. }
    lra.
  Qed.

  (* `error`: more than the errors of doubled_area and of each dot. The other two corners are alike. *)
  Theorem error_of_a_shape : Rabs area <= S / 2 /\ Rabs dot_0 <= S / 2 /\
    Rabs (shape_doubled_area - area) <= 202 / 100 * u * S /\ Rabs (shape_dot_0 - dot_0) <= 202 / 100 * u * S /\
    Rabs (shape_doubled_area - area) <= shape_error_computed /\ Rabs (shape_dot_0 - dot_0) <= shape_error_computed.
  Proof.
    assert (U := u_value); destruct S_large as [S0 E]; assert (L := error_computed_large).
    destruct parts_nonnegative as (P0 & P1 & P2).
    destruct (cross_error _ _ _ _ _ _ _ _ D2y D2x D1y D1x) as [A1 A2].
    destruct (dot_error _ _ _ _ _ _ _ _ D1x D1y D2x D2y) as [B1 B2].
    fold shape_doubled_area in A2; fold area in A1, A2.
    assert (Ta : s2y ^ 2 + s2x ^ 2 + (s1y ^ 2 + s1x ^ 2) <= S) by (unfold S; lra).
    assert (Tb : s1x ^ 2 + s1y ^ 2 + (s2x ^ 2 + s2y ^ 2) <= S) by (unfold S; lra).
    assert (Ka : 402 / 100 * u * ((s2y ^ 2 + s2x ^ 2 + (s1y ^ 2 + s1x ^ 2)) / 2) <= 402 / 100 * u * (S / 2))
      by (apply Rmult_le_compat_l; lra).
    assert (Kb : 402 / 100 * u * ((s1x ^ 2 + s1y ^ 2 + (s2x ^ 2 + s2y ^ 2)) / 2) <= 402 / 100 * u * (S / 2))
      by (apply Rmult_le_compat_l; lra).
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    assert (Rabs (shape_dot_0 - dot_0) <= 202 / 100 * u * S).
    { unfold shape_dot_0, dot_0.
      replace (- dot2 s1x' s1y' s2x' s2y' - - (s1x * s2x + s1y * s2y))
        with (- (dot2 s1x' s1y' s2x' s2y' - (s1x * s2x + s1y * s2y))) by ring; rewrite Rabs_Ropp; lra. }
    unfold dot_0 at 1; rewrite Rabs_Ropp; repeat split; lra.
  Qed.

  (* is_tame(): the triangle is counter-clockwise. *)
  Theorem tame_is_counter_clockwise : rnd (tame_area * shape_sum) < shape_doubled_area -> 0 < area.
  Proof.
    intro T; assert (U := u_value); destruct S_large as [S0 E]; destruct sum_error as [L _].
    destruct eta_value as [E0 _]; destruct error_of_a_shape as (_ & _ & A & _).
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    destruct (rnd_bounds (tame_area * shape_sum)) as [R _].
    { unfold tame_area; apply Rmult_le_pos; [lra|]; assert (604 / 100 * u * S <= / 2 * S)
        by (apply Rmult_le_compat_r; lra). lra. }
    apply below_absolute in A; unfold tame_area in *.
    assert (604 / 100 * u * S <= / 1000 * S) by (apply Rmult_le_compat_r; lra).
    assert (u * S <= / 1000000000000000 * S) by (apply Rmult_le_compat_r; lra).
    assert (9 / 10 * S <= shape_sum) by lra.
    assert ((1 - u) * (/ 2 ^ 20 * (9 / 10 * S)) <= (1 - u) * (/ 2 ^ 20 * shape_sum))
      by (apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra).
    assert (9 / 10 * (/ 2 ^ 20 * (9 / 10 * S)) <= (1 - u) * (/ 2 ^ 20 * (9 / 10 * S)))
      by (apply Rmult_le_compat_r; lra).
    lra.
  Qed.

  (* is_not_larger(): the area is at most the bound. *)
  Theorem area_filter : forall bound,
    rnd (shape_doubled_area + rnd (area_errors * shape_error_computed)) < rnd (2 * bound) -> area / 2 < bound.
  Proof.
    intros bound H; apply below_before_rounding in H.
    assert (U := u_value); destruct S_large as [S0 _]; assert (L := error_computed_large).
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    assert (shape_error_computed <= rnd (area_errors * shape_error_computed)).
    { rewrite <- (rnd_of_double shape_error_computed) at 1 by apply rnd_is_double.
      apply rnd_monotone; unfold area_errors; lra. }
    destruct error_of_a_shape as (_ & _ & _ & _ & A & _); apply below_absolute in A; lra.
  Qed.

  (* is_not_longer(): no side is longer than the bound. *)
  Theorem length_filter : forall longest bound,
    length2 s0x' s0y' <= longest -> length2 s1x' s1y' <= longest -> length2 s2x' s2y' <= longest ->
    rnd (longest * length_slack) < rnd (bound * bound) ->
    s0x ^ 2 + s0y ^ 2 < bound ^ 2 /\ s1x ^ 2 + s1y ^ 2 < bound ^ 2 /\ s2x ^ 2 + s2y ^ 2 < bound ^ 2.
  Proof.
    intros longest bound L0 L1 L2 H; apply below_before_rounding in H; unfold length_slack in H.
    assert (U := u_value); destruct S_large as [S0 E]; destruct parts_nonnegative as (P0 & P1 & P2).
    destruct eta_value as [E0 _].
    assert (A := below_absolute _ _ _ (length_error _ _ _ _ D0x D0y)).
    assert (B := below_absolute _ _ _ (length_error _ _ _ _ D1x D1y)).
    assert (C := below_absolute _ _ _ (length_error _ _ _ _ D2x D2y)).
    unfold S in S0, E.
    set (a := s0x ^ 2 + s0y ^ 2) in *; set (b := s1x ^ 2 + s1y ^ 2) in *; set (c := s2x ^ 2 + s2y ^ 2) in *.
    assert (W : forall v, 0 <= v -> u * v <= / 1000 * v) by (intros v V; apply Rmult_le_compat_r; lra).
    assert (Wa := W a P0); assert (Wb := W b P1); assert (Wc := W c P2); clear W.
    assert (Big : a + b + c <= 4 * longest) by lra.
    assert (uBig : u * (a + b + c) <= u * (4 * longest)) by (apply Rmult_le_compat_l; lra).
    assert (Pos : 0 < longest) by lra.
    assert (Small : 3 * eta <= / 100 * u * longest) by lra.
    assert (One : forall v, 0 <= v -> (1 - 402 / 100 * u) * v <= longest + 3 * eta -> v < bound ^ 2).
    { intros v V K.
      assert (M : (1 + / 100 * u) * longest <= (1 - 402 / 100 * u) * ((1 + 8 * u) * longest)).
      { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [lra|unfold u; lra]. }
      assert (v <= (1 + 8 * u) * longest) by (apply Rmult_le_reg_l with (1 - 402 / 100 * u); lra).
      lra. }
    repeat split; apply One; lra.
  Qed.

  (* is_outside_circle(): p and q are the vectors to the ends of side 0 from the point d. sign_of_the_circle_test in
     Pencil.v says what the sign of this number means. *)
  Theorem outside_circle_filter : forall px' px py' py qx' qx qy' qy,
    difference_of px' px -> difference_of py' py -> difference_of qx' qx -> difference_of qy' qy ->
    least_square <= circle_squares px' py' qx' qy' ->
    rnd (rnd (circle_bound * shape_sum) * circle_squares px' py' qx' qy')
      < circle_sine shape_doubled_area shape_dot_0 px' py' qx' qy' ->
    0 < area * (px * qx + py * qy) + dot_0 * (qx * py - qy * px).
  Proof.
    intros px' px py' py qx' qx qy' qy Px Py Qx Qy L H.
    assert (U := u_value); destruct S_large as [S0 E]; destruct sum_error as [Ls _].
    destruct error_of_a_shape as (A1 & B1 & A2 & B2 & _).
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    apply (sine_is_positive shape_sum S shape_doubled_area area shape_dot_0 dot_0) with px' py' qx' qy';
      try assumption; try exact S_large; try lra; split; lra.
  Qed.
End Shape.
