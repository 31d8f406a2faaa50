(* Doubles and rounding to nearest, and how errors add up in sums and products. Exponents have no upper limit here; that
   nothing overflows is proved in ranges_of_*.g. *)
From Coq Require Export ZArith Reals Lra Psatz.
From Flocq Require Export Core.
From Flocq Require Import Relative Plus_error.
Open Scope R_scope.

Definition is_double (v : R) : Prop := generic_format radix2 (FLT_exp (-1074) 53) v.
Definition rnd (v : R) : R := round radix2 (FLT_exp (-1074) 53) ZnearestE v.
Definition u : R := / 2 ^ 53.
Definition two_to (e : Z) : R := bpow radix2 e.

(* v is a multiple of 2^e. *)
Definition multiple (e : Z) (v : R) : Prop := generic_format radix2 (FIX_exp e) v.

Global Instance precision_positive : Prec_gt_0 53.
Proof. reflexivity. Qed.

Lemma u_is_half_an_ulp : / 2 * bpow radix2 (- 53 + 1) = u.
Proof. unfold u; simpl; lra. Qed.

Lemma u_value : 0 < u < / 1000000000000000.
Proof. unfold u; split; lra. Qed.

Lemma rnd_is_double : forall v, is_double (rnd v).
Proof. intro; apply generic_format_round; auto with typeclass_instances. Qed.

Lemma rnd_multiple : forall e v, multiple e v -> multiple e (rnd v).
Proof. intros e v H; apply generic_round_generic; auto with typeclass_instances. Qed.

Lemma multiple_product : forall e f v w, multiple e v -> multiple f w -> multiple (e + f) (v * w).
Proof.
  intros e f v w V W; apply FIX_format_generic in V, W; destruct V as [[a i] -> A], W as [[b j] -> B].
  simpl in A, B; subst; apply generic_format_FIX; exists (Float radix2 (a * b) (e + f)); [|reflexivity].
  unfold F2R; simpl; rewrite mult_IZR, bpow_plus; ring.
Qed.

Lemma multiple_sum : forall e v w, multiple e v -> multiple e w -> multiple e (v + w).
Proof.
  intros e v w V W; apply FIX_format_generic in V, W; destruct V as [[a i] -> A], W as [[b j] -> B].
  simpl in A, B; subst; apply generic_format_FIX; exists (Float radix2 (a + b) e); [|reflexivity].
  unfold F2R; simpl; rewrite plus_IZR; ring.
Qed.

Lemma multiple_opposite : forall e v, multiple e v -> multiple e (- v).
Proof. intros; now apply generic_format_opp. Qed.

Lemma multiple_absolute : forall e v, multiple e v -> multiple e (Rabs v).
Proof. intros; now apply generic_format_abs. Qed.

Lemma opposite_is_double : forall v, is_double v -> is_double (- v).
Proof. intros; now apply generic_format_opp. Qed.

Lemma absolute_is_double : forall v, is_double v -> is_double (Rabs v).
Proof. intros; now apply generic_format_abs. Qed.

(* A multiple of 2^e that is not zero is at least 2^e. *)
Lemma multiple_at_least : forall e v, multiple e v -> v <> 0 -> two_to e <= Rabs v.
Proof.
  intros e v V N; apply FIX_format_generic in V; destruct V as [[a i] -> A]; simpl in A; subst.
  assert (a <> 0%Z) by (intros ->; apply N; unfold F2R; simpl; ring).
  unfold two_to; rewrite <- F2R_Zabs; replace (bpow radix2 e) with (F2R (Float radix2 1 e)) by apply F2R_bpow.
  apply F2R_le; lia.
Qed.

(* Rounding has a relative error of at most u, of the exact and of the rounded value, unless the result is subnormal. *)
Lemma rnd_error : forall e v, (-1022 <= e)%Z -> multiple e v ->
  Rabs (rnd v - v) <= u * Rabs v /\ Rabs (rnd v - v) <= u * Rabs (rnd v).
Proof.
  intros e v E M; destruct (Req_dec v 0) as [->|N].
  { unfold rnd; rewrite round_0 by auto with typeclass_instances; rewrite Rminus_0_r, Rabs_R0; lra. }
  assert (B := multiple_at_least e v M N); unfold two_to in B.
  assert (bpow radix2 (-1074 + 53 - 1) <= Rabs v) by (apply Rle_trans with (2 := B); apply bpow_le; lia).
  rewrite <- u_is_half_an_ulp; split.
  - now apply relative_error_N_FLT.
  - now apply relative_error_N_FLT_round.
Qed.

(* The same for a sum of doubles, also if it is subnormal. *)
Lemma rnd_sum_error : forall v w, is_double v -> is_double w ->
  Rabs (rnd (v + w) - (v + w)) <= u * Rabs (v + w) /\ Rabs (rnd (v + w) - (v + w)) <= u * Rabs (rnd (v + w)).
Proof.
  intros v w V W; assert (U := u_value).
  destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun x => negb (Z.even x)) v w V W) as (eps & B & E).
  unfold rnd; rewrite E; replace (u_ro radix2 53) with u in B by (symmetry; exact u_is_half_an_ulp).
  replace ((v + w) * (1 + eps) - (v + w)) with (eps * (v + w)) by ring.
  assert (B2 : u / (1 + u) <= u).
  { apply Rmult_le_reg_r with (1 + u); [lra|]; replace (u / (1 + u) * (1 + u)) with u by (field; lra); nra. }
  rewrite !Rabs_mult; assert (P := Rabs_pos (v + w)); split; [apply Rmult_le_compat_r; lra|].
  assert (L : 1 - Rabs eps <= Rabs (1 + eps)) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  assert (Rabs eps <= u * Rabs (1 + eps)).
  { apply Rle_trans with (u * (1 - Rabs eps)); [|apply Rmult_le_compat_l; lra].
    apply Rmult_le_compat_r with (r := 1 + u) in B; [|lra].
    replace (u / (1 + u) * (1 + u)) with u in B by (field; lra); lra. }
  replace (u * (Rabs (v + w) * Rabs (1 + eps))) with (u * Rabs (1 + eps) * Rabs (v + w)) by ring.
  apply Rmult_le_compat_r; lra.
Qed.

(* The same for any value: a subnormal result is off by at most half the least double. *)
Lemma rnd_any_error : forall v, Rabs (rnd v - v) <= u * Rabs v + two_to (-1075).
Proof.
  intro v; destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun x => negb (Z.even x)) v) as (eps & eta & A & B & _ & E).
  unfold rnd; rewrite E, <- u_is_half_an_ulp.
  replace (v * (1 + eps) + eta - v) with (eps * v + eta) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult; apply Rplus_le_compat.
  - apply Rmult_le_compat_r; [apply Rabs_pos|exact A].
  - unfold two_to; replace (bpow radix2 (-1075)) with (/ 2 * bpow radix2 (-1074)); [exact B|].
    change (-1075)%Z with (-1 + -1074)%Z; rewrite bpow_plus; simpl; lra.
Qed.

(* v' approximates v: |v| <= m and |v' - v| <= c m. *)
Definition close (c m v' v : R) : Prop := Rabs v <= m /\ Rabs (v' - v) <= c * m.

Lemma close_weaker : forall c c' m v' v, c <= c' -> close c m v' v -> close c' m v' v.
Proof.
  intros c c' m v' v C (A & B); split; [assumption|]; apply Rle_trans with (1 := B).
  assert (P := Rabs_pos v); apply Rmult_le_compat_r; lra.
Qed.

Lemma close_larger : forall c m m' v' v, 0 <= c -> m <= m' -> close c m v' v -> close c m' v' v.
Proof.
  intros c m m' v' v C M (A & B); split; [lra|]; apply Rle_trans with (1 := B); apply Rmult_le_compat_l; lra.
Qed.

Lemma close_opposite : forall c m v' v, close c m v' v -> close c m (- v') (- v).
Proof.
  intros c m v' v (A & B); split; [now rewrite Rabs_Ropp|].
  replace (- v' - - v) with (- (v' - v)) by ring; now rewrite Rabs_Ropp.
Qed.

Lemma close_bound : forall c m v' v, close c m v' v -> Rabs v' <= (1 + c) * m.
Proof.
  intros c m v' v (A & B); replace v' with (v' - v + v) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(* A rounded sum, difference and product of approximations. *)
Lemma close_rounded : forall c c' m w v, 0 <= c -> c + u * (1 + c) <= c' -> close c m w v ->
  Rabs (rnd w - w) <= u * Rabs w -> close c' m (rnd w) v.
Proof.
  intros c c' m w v C C' H E; assert (B := close_bound _ _ _ _ H); destruct H as (M & H); split; [assumption|].
  assert (U := u_value); assert (P := Rabs_pos v); assert (m0 : 0 <= m) by lra.
  replace (rnd w - v) with (rnd w - w + (w - v)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
  apply Rle_trans with (u * ((1 + c) * m) + c * m).
  - apply Rplus_le_compat; [|assumption]; apply Rle_trans with (1 := E); apply Rmult_le_compat_l; lra.
  - replace (u * ((1 + c) * m) + c * m) with ((c + u * (1 + c)) * m) by ring; apply Rmult_le_compat_r; lra.
Qed.

Lemma close_exact_sum : forall c m n v' v w' w, close c m v' v -> close c n w' w -> close c (m + n) (v' + w') (v + w).
Proof.
  intros c m n v' v w' w (A & B) (C & D); split.
  - apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - replace (v' + w' - (v + w)) with (v' - v + (w' - w)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

Lemma close_exact_product : forall c d m n v' v w' w, 0 <= c -> 0 <= d -> close c m v' v -> close d n w' w ->
  close (c + d + c * d) (m * n) (v' * w') (v * w).
Proof.
  intros c d m n v' v w' w c0 d0 (A & B) (C & D).
  assert (Pv := Rabs_pos v); assert (Pw := Rabs_pos w); split.
  - rewrite Rabs_mult; apply Rmult_le_compat; lra.
  - replace (v' * w' - v * w) with ((v' - v) * w + v * (w' - w) + (v' - v) * (w' - w)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    replace ((c + d + c * d) * (m * n)) with (c * m * n + m * (d * n) + c * m * (d * n)) by ring.
    apply Rplus_le_compat; [apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat|]; rewrite Rabs_mult;
      apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.

Lemma close_sum : forall c d m n v' v w' w, 0 <= c -> c + u * (1 + c) <= d -> is_double v' -> is_double w' ->
  close c m v' v -> close c n w' w -> close d (m + n) (rnd (v' + w')) (v + w).
Proof.
  intros c d m n v' v w' w C D V W A B; apply (close_rounded c); try assumption; [now apply close_exact_sum|].
  now apply rnd_sum_error.
Qed.

Lemma close_difference : forall c d m n v' v w' w, 0 <= c -> c + u * (1 + c) <= d -> is_double v' -> is_double w' ->
  close c m v' v -> close c n w' w -> close d (m + n) (rnd (v' - w')) (v - w).
Proof.
  intros c d m n v' v w' w C D V W A B; unfold Rminus; apply (close_sum c); try assumption.
  - now apply opposite_is_double.
  - now apply close_opposite.
Qed.

Lemma close_product : forall e f c d k m n v' v w' w, 0 <= c -> 0 <= d ->
  c + d + c * d + u * (1 + (c + d + c * d)) <= k ->
  multiple e v' -> multiple f w' -> (-1022 <= e + f)%Z -> close c m v' v -> close d n w' w ->
  close k (m * n) (rnd (v' * w')) (v * w).
Proof.
  intros e f c d k m n v' v w' w C D K V W E A B; apply (close_rounded (c + d + c * d)); try assumption.
  - assert (0 <= c * d) by now apply Rmult_le_pos. lra.
  - now apply close_exact_product.
  - now apply (rnd_error (e + f)); [|apply multiple_product].
Qed.
