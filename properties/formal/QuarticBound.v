(* The bounds of T3 and T3-sharp of THEORY.md for the edges of one triangle, given by the squares of their lengths. *)
From Pardel Require Import Plane LeastArea.

(* r* of T3-sharp. *)
Definition sharp_bound (rho delta : R) : R := 2 * rho ^ 2 * sqrt delta / Rpower (4 * rho ^ 2 - 1) (1 / 4).

(* Fourth roots and powers of 3/2. *)
Lemma fourth_root : forall v, 0 < v -> 0 < Rpower v (1 / 4) /\ Rpower v (1 / 4) ^ 4 = v.
Proof.
  intros v Hv; split; [unfold Rpower; apply exp_pos|].
  rewrite <- Rpower_pow by (unfold Rpower; apply exp_pos).
  rewrite Rpower_mult; replace (1 / 4 * INR 4) with 1 by (simpl; field).
  now apply Rpower_1.
Qed.

Lemma power_three_halves : forall v, 0 < v -> 0 < Rpower v (3 / 2) /\ Rpower v (3 / 2) ^ 2 = v ^ 3.
Proof.
  intros v Hv; split; [unfold Rpower; apply exp_pos|].
  rewrite <- Rpower_pow by (unfold Rpower; apply exp_pos).
  rewrite Rpower_mult; replace (3 / 2 * INR 2) with (INR 3) by (simpl; field).
  now apply Rpower_pow.
Qed.

Lemma at_most_of_fourth_powers : forall u v, 0 <= v -> u ^ 4 <= v ^ 4 -> u <= v.
Proof.
  intros u v Hv H; apply at_most_of_squares; [assumption|]; apply at_most_of_squares; [apply pow2_ge_0|].
  replace ((u ^ 2) ^ 2) with (u ^ 4) by ring; replace ((v ^ 2) ^ 2) with (v ^ 4) by ring; exact H.
Qed.

Section Bound.
  Variables S T U k r rho delta : R.
  Hypothesis S_positive : 0 < S.
  Hypothesis S_least : S <= T /\ S <= U.
  Hypothesis heron : 4 * k ^ 2 = 2 * S * T + 2 * T * U + 2 * U * S - S ^ 2 - T ^ 2 - U ^ 2.
  Hypothesis k_positive : 0 < k.
  Hypothesis circumradius : 4 * r ^ 2 * k ^ 2 = S * T * U.
  Hypothesis r_nonnegative : 0 <= r.
  Hypothesis rho_nonnegative : 0 <= rho.
  Hypothesis rho_bounds : r ^ 2 <= rho ^ 2 * S.
  Hypothesis delta_bounds : k / 2 <= delta.

  Let s : R := r ^ 2 / S.

  Lemma s_defined : s * S = r ^ 2.
  Proof. unfold s; field; lra. Qed.

  Lemma k_squared_positive : 0 < k ^ 2.
  Proof. apply pow_lt; lra. Qed.

  Lemma s_at_least : 1 / 3 <= s.
  Proof.
    assert (S <= 3 * r ^ 2) by (apply (ratio_at_least S T U (k ^ 2)); auto using k_squared_positive).
    assert (E := s_defined); destruct (Rle_or_lt (1 / 3) s); [assumption|nra].
  Qed.

  Lemma s_at_most : s <= rho ^ 2.
  Proof. assert (E := s_defined); destruct (Rle_or_lt s (rho ^ 2)); [assumption|nra]. Qed.

  Lemma r_positive : 0 < r ^ 2.
  Proof. apply (q_positive S T U (k ^ 2)); auto using k_squared_positive. Qed.

  (* The two sides of area_at_least, in s. *)
  Lemma in_s : T * U * r ^ 2 - S ^ 2 * (4 * r ^ 2 - S) = (4 * k ^ 2 * s ^ 4 - r ^ 4 * (4 * s - 1)) * (S ^ 3 / r ^ 4).
  Proof.
    assert (Q := r_positive).
    assert (0 < r) by (destruct r_nonnegative as [|<-]; [assumption|simpl in Q; lra]).
    replace (T * U) with (4 * r ^ 2 * k ^ 2 / S) by (rewrite circumradius; field; lra).
    unfold s; field; lra.
  Qed.

  Lemma weight_positive : 0 < S ^ 3 / r ^ 4.
  Proof.
    assert (Q := r_positive); apply Rdiv_lt_0_compat; [now apply pow_lt|].
    replace (r ^ 4) with (r ^ 2 * r ^ 2) by ring; nra.
  Qed.

  Lemma in_own_ratio : r ^ 4 * (4 * s - 1) <= 4 * k ^ 2 * s ^ 4.
  Proof.
    assert (H : S ^ 2 * (4 * r ^ 2 - S) <= T * U * r ^ 2)
      by (apply (area_at_least S T U (k ^ 2)); auto using k_squared_positive).
    assert (E := in_s); assert (W := weight_positive).
    destruct (Rle_or_lt (r ^ 4 * (4 * s - 1)) (4 * k ^ 2 * s ^ 4)); [assumption|nra].
  Qed.

  Lemma in_own_ratio_equal : r ^ 4 * (4 * s - 1) = 4 * k ^ 2 * s ^ 4 <-> T = S \/ U = S.
  Proof.
    rewrite <- (area_least_if_isosceles S T U (k ^ 2) (r ^ 2)) by auto using k_squared_positive.
    assert (E := in_s); assert (W := weight_positive); split; intro H.
    - rewrite H in E; lra.
    - replace (T * U * r ^ 2 - S ^ 2 * (4 * r ^ 2 - S)) with 0 in E by lra.
      symmetry in E; apply Rmult_integral in E; lra.
  Qed.

  Lemma rho_at_least : 1 / 3 <= rho ^ 2.
  Proof. assert (A := s_at_least); assert (B := s_at_most); lra. Qed.

  Lemma s4_positive : 0 < s ^ 4.
  Proof. assert (A := s_at_least); apply pow_lt; lra. Qed.

  Lemma areas : k ^ 2 <= 4 * delta ^ 2.
  Proof. nra. Qed.

  (* In one step each: the least area of the own ratio, the bound on the area, the bound on the ratio. *)
  Lemma quartic_bound : r ^ 4 * (4 * rho ^ 2 - 1) <= 16 * (rho ^ 2) ^ 4 * delta ^ 2.
  Proof.
    assert (A := s_at_least); assert (B := s_at_most); assert (C := in_own_ratio); assert (D := areas).
    assert (P := s4_positive); assert (G := quartic_grows_weakly s (rho ^ 2) A B).
    assert (0 <= (rho ^ 2) ^ 4) by (apply pow_le; lra).
    assert (r ^ 4 * (4 * s - 1) <= 16 * delta ^ 2 * s ^ 4).
    { apply Rle_trans with (1 := C); replace (16 * delta ^ 2 * s ^ 4) with (4 * (4 * delta ^ 2) * s ^ 4) by ring.
      apply Rmult_le_compat_r; lra. }
    apply Rmult_le_reg_r with (s ^ 4 * (4 * s - 1)); [apply Rmult_lt_0_compat; lra|].
    apply Rle_trans with (16 * delta ^ 2 * s ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)).
    - replace (r ^ 4 * (4 * rho ^ 2 - 1) * (s ^ 4 * (4 * s - 1)))
        with (r ^ 4 * (4 * s - 1) * ((4 * rho ^ 2 - 1) * s ^ 4)) by ring.
      apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|assumption].
    - replace (16 * (rho ^ 2) ^ 4 * delta ^ 2 * (s ^ 4 * (4 * s - 1)))
        with (16 * delta ^ 2 * s ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) by ring.
      apply Rmult_le_compat_l; [|assumption].
      apply Rmult_le_pos; [assert (0 <= delta ^ 2) by apply pow2_ge_0; lra|lra].
  Qed.

  Lemma quartic_bound_equal :
    r ^ 4 * (4 * rho ^ 2 - 1) = 16 * (rho ^ 2) ^ 4 * delta ^ 2 <->
    k / 2 = delta /\ r ^ 2 = rho ^ 2 * S /\ (T = S \/ U = S).
  Proof.
    assert (A := s_at_least); assert (B := s_at_most); assert (C := in_own_ratio); assert (D := areas).
    assert (P := s4_positive); assert (E := s_defined); split.
    - intro H.
      assert (R4 : 0 <= r ^ 4) by (apply pow_le; lra).
      assert (Q4 : 0 < (rho ^ 2) ^ 4) by (apply pow_lt; lra).
      assert (Own : 16 * delta ^ 2 * s ^ 4 <= r ^ 4 * (4 * s - 1)).
      { apply Rmult_le_reg_r with ((rho ^ 2) ^ 4 ); [assumption|].
        replace (16 * delta ^ 2 * s ^ 4 * (rho ^ 2) ^ 4) with (16 * (rho ^ 2) ^ 4 * delta ^ 2 * s ^ 4) by ring.
        rewrite <- H.
        replace (r ^ 4 * (4 * rho ^ 2 - 1) * s ^ 4) with (r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)) by ring.
        replace (r ^ 4 * (4 * s - 1) * (rho ^ 2) ^ 4) with (r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) by ring.
        apply Rmult_le_compat_l; [assumption|now apply quartic_grows_weakly]. }
      assert (K : k / 2 = delta).
      { assert (16 * delta ^ 2 * s ^ 4 <= 4 * k ^ 2 * s ^ 4) by lra.
        assert (16 * delta ^ 2 <= 4 * k ^ 2) by (apply Rmult_le_reg_r with (s ^ 4); lra). nra. }
      split; [assumption|].
      assert (I : r ^ 4 * (4 * s - 1) = 4 * k ^ 2 * s ^ 4)
        by (apply Rle_antisym; [assumption|rewrite <- K in Own; nra]).
      split; [|now apply in_own_ratio_equal].
      destruct B as [B|B]; [exfalso|rewrite <- B; lra].
      assert (G := quartic_grows s (rho ^ 2) A B).
      assert (0 < r ^ 4) by (assert (Q := r_positive); replace (r ^ 4) with (r ^ 2 * r ^ 2) by ring; nra).
      assert (L : r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4) < r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4))
        by now apply Rmult_lt_compat_l.
      replace (r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)) with (r ^ 4 * (4 * rho ^ 2 - 1) * s ^ 4) in L by ring.
      replace (r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) with (r ^ 4 * (4 * s - 1) * (rho ^ 2) ^ 4) in L by ring.
      rewrite H, I, <- K in L; apply (Rlt_irrefl (4 * k ^ 2 * s ^ 4 * (rho ^ 2) ^ 4)).
      replace (16 * (rho ^ 2) ^ 4 * (k / 2) ^ 2 * s ^ 4) with (4 * k ^ 2 * s ^ 4 * (rho ^ 2) ^ 4) in L by field.
      exact L.
    - intros (K & Q & I).
      assert (s = rho ^ 2) as <- by (apply Rmult_eq_reg_r with S; lra).
      apply in_own_ratio_equal in I; rewrite I, <- K; field.
  Qed.

  Lemma sharp_bound_to_the_fourth : 0 <= sharp_bound rho delta /\
    (4 * rho ^ 2 - 1) * sharp_bound rho delta ^ 4 = 16 * (rho ^ 2) ^ 4 * delta ^ 2.
  Proof.
    assert (H := rho_at_least); unfold sharp_bound.
    destruct (fourth_root (4 * rho ^ 2 - 1)) as [P Q]; [lra|].
    set (w := Rpower (4 * rho ^ 2 - 1) (1 / 4)) in *.
    assert (D : 0 <= delta) by lra; assert (D2 := sqrt_pos delta); assert (D3 := pow2_sqrt delta D).
    split.
    - apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
      apply Rmult_le_pos; [lra|assumption].
    - replace (delta ^ 2) with (sqrt delta ^ 4) by (replace (sqrt delta ^ 4) with ((sqrt delta ^ 2) ^ 2) by ring;
        now rewrite D3).
      rewrite <- Q at 1; field; lra.
  Qed.

  Lemma sharp_bound_holds : r <= sharp_bound rho delta.
  Proof.
    destruct sharp_bound_to_the_fourth as [P Q]; assert (H := quartic_bound); assert (G := rho_at_least).
    apply at_most_of_fourth_powers; [assumption|].
    apply Rmult_le_reg_l with (4 * rho ^ 2 - 1); [lra|]; lra.
  Qed.

  Lemma sharp_bound_equal :
    r = sharp_bound rho delta <-> k / 2 = delta /\ r ^ 2 = rho ^ 2 * S /\ (T = S \/ U = S).
  Proof.
    rewrite <- quartic_bound_equal.
    destruct sharp_bound_to_the_fourth as [P Q]; assert (G := rho_at_least); split; intro H.
    - rewrite H; lra.
    - apply Rle_antisym; [apply sharp_bound_holds|].
      apply at_most_of_fourth_powers; [assumption|].
      apply Rmult_le_reg_l with (4 * rho ^ 2 - 1); [lra|]; lra.
  Qed.

  Lemma weak_bound_holds : r <= 2 * Rpower rho (3 / 2) * sqrt delta.
  Proof.
    assert (H := quartic_bound); assert (G := rho_at_least).
    assert (P : 0 < rho) by (destruct rho_nonnegative as [|<-]; [assumption|simpl in G; lra]).
    destruct (power_three_halves rho P) as [W W2]; set (w := Rpower rho (3 / 2)) in *.
    assert (D : 0 <= delta) by lra; assert (D2 := sqrt_pos delta); assert (D3 := pow2_sqrt delta D).
    apply at_most_of_fourth_powers; [apply Rmult_le_pos; lra|].
    replace ((2 * w * sqrt delta) ^ 4) with (16 * (w ^ 2) ^ 2 * (sqrt delta ^ 2) ^ 2) by ring.
    rewrite W2, D3.
    assert (R4 : 0 <= r ^ 4) by (apply pow_le; lra).
    apply Rmult_le_reg_r with (rho ^ 2); [now apply pow_lt|].
    apply Rle_trans with (r ^ 4 * (4 * rho ^ 2 - 1)); [apply Rmult_le_compat_l; lra|].
    apply Rle_trans with (1 := H); right; ring.
  Qed.
End Bound.
