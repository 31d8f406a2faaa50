(* The filter of orient2d() in parallel/arithmetic/predicates.hpp: if is_certain() answers `true`, the sign is that of
   the exact determinant. Constants.v has the constants of the source. *)
From Pardel Require Import Rounding Constants.

(* is_usable() of the source; that nothing overflows below largest_coordinate is proved in ranges_of_predicates.g. *)
Definition usable (v : R) : Prop := is_double v /\ (v = 0 \/ smallest_coordinate <= Rabs v).

Lemma usable_multiple : forall v, usable v -> multiple (-192) v.
Proof.
  intros v [V [->|B]]; [apply generic_format_0|].
  unfold multiple; apply generic_inclusion_mag with (2 := V); intros N.
  assert (L : (-139 <= mag radix2 v)%Z).
  { apply mag_ge_bpow; replace (bpow radix2 (-139 - 1)) with smallest_coordinate; [exact B|].
    unfold smallest_coordinate; simpl; lra. }
  unfold FIX_exp, FLT_exp; lia.
Qed.

(* A difference of coordinates. *)
Record coordinate (v' v : R) : Prop := {
  coordinate_double : is_double v';
  coordinate_multiple : multiple (-192) v';
  coordinate_close : close u (Rabs v) v' v;
  coordinate_back : Rabs (v' - v) <= u * Rabs v' }.

Lemma difference : forall p q, usable p -> usable q -> coordinate (rnd (p - q)) (p - q).
Proof.
  intros p q P Q; unfold Rminus at 1; split.
  - apply rnd_is_double.
  - apply rnd_multiple, multiple_sum; [|apply multiple_opposite]; now apply usable_multiple.
  - split; [apply Rle_refl|]; apply rnd_sum_error; [apply P|apply opposite_is_double, Q].
  - apply rnd_sum_error; [apply P|apply opposite_is_double, Q].
Qed.

(* If a value is farther from zero than the exact one can be from it, both have the same sign. *)
Lemma same_sign : forall v' v, Rabs (v' - v) < Rabs v' -> (0 < v' <-> 0 < v) /\ (v' < 0 <-> v < 0).
Proof.
  intros v' v H; unfold Rabs in H; repeat destruct Rcase_abs; split; split; lra.
Qed.

(* The error of a product of two differences, relative to the rounded product: three roundings. *)
Lemma product_back : forall a' a b' b, coordinate a' a -> coordinate b' b ->
  Rabs (rnd (a' * b') - a * b) <= ((1 + u) ^ 3 - 1) * Rabs (rnd (a' * b')).
Proof.
  intros a' a b' b A B; assert (U := u_value).
  assert (E : Rabs (rnd (a' * b') - a' * b') <= u * Rabs (rnd (a' * b')))
    by (apply (rnd_error (-192 + -192)); [lia|apply multiple_product; [apply A|apply B]]).
  set (p := rnd (a' * b')) in *.
  assert (M : Rabs (a' * b') <= (1 + u) * Rabs p).
  { replace (a' * b') with (p - (p - a' * b')) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite Rabs_Ropp; lra. }
  assert (close (2 * u + u ^ 2) (Rabs a' * Rabs b') (a * b) (a' * b')).
  { replace (2 * u + u ^ 2) with (u + u + u * u) by ring.
    apply close_exact_product; try lra; (split; [apply Rle_refl|]);
      rewrite Rabs_minus_sym; [apply A|apply B]. }
  destruct H as [_ H]; rewrite <- Rabs_mult in H.
  replace (p - a * b) with (p - a' * b' + - (a * b - a' * b')) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
  assert ((2 * u + u ^ 2) * Rabs (a' * b') <= (2 * u + u ^ 2) * ((1 + u) * Rabs p))
    by (apply Rmult_le_compat_l; [nra|assumption]).
  replace (((1 + u) ^ 3 - 1) * Rabs p) with (u * Rabs p + (2 * u + u ^ 2) * ((1 + u) * Rabs p)) by ring; lra.
Qed.

(* Orientation<double>(ax, ay, bx, by). *)
Section Orientation.
  Variables ax ay bx by_ : R.
  Definition orientation_left : R := rnd (ax * by_).
  Definition orientation_right : R := rnd (ay * bx).
  Definition orientation_determinant : R := rnd (orientation_left - orientation_right).
  Definition orientation_error : R := rnd (orient2d_bound * rnd (Rabs orientation_left + Rabs orientation_right)).
  Definition orientation_is_certain : Prop := orientation_error < Rabs orientation_determinant.
End Orientation.

Lemma orient2d_bound_multiple : multiple (-102) orient2d_bound.
Proof.
  apply generic_format_FIX; exists (Float radix2 (3 * 2 ^ 49 + 1) (-102)); [|reflexivity].
  unfold orient2d_bound, F2R; simpl; lra.
Qed.

Lemma orientation_certain : forall ax ay bx by_ AX AY BX BY,
  coordinate ax AX -> coordinate ay AY -> coordinate bx BX -> coordinate by_ BY ->
  orientation_is_certain ax ay bx by_ ->
  let d := orientation_determinant ax ay bx by_ in let D := AX * BY - AY * BX in
  (0 < d <-> 0 < D) /\ (d < 0 <-> D < 0).
Proof.
  intros ax ay bx by_ AX AY BX BY A B C D S d E; assert (U := u_value).
  assert (L := product_back ax AX by_ BY A D); assert (R := product_back ay AY bx BX B C).
  assert (Ml : multiple (-384) (orientation_left ax by_))
    by (apply rnd_multiple; change (-384)%Z with (-192 + -192)%Z; apply multiple_product; [apply A|apply D]).
  assert (Mr : multiple (-384) (orientation_right ay bx))
    by (apply rnd_multiple; change (-384)%Z with (-192 + -192)%Z; apply multiple_product; [apply B|apply C]).
  unfold orientation_is_certain, orientation_error in S; unfold d, orientation_determinant in *.
  assert (Fl : is_double (orientation_left ax by_)) by apply rnd_is_double.
  assert (Fr : is_double (orientation_right ay bx)) by apply rnd_is_double.
  fold (orientation_left ax by_) in L; fold (orientation_right ay bx) in R.
  set (l := orientation_left ax by_) in *; set (r := orientation_right ay bx) in *.
  destruct (rnd_sum_error (Rabs l) (Rabs r)) as [Sum _]; try now apply absolute_is_double.
  assert (P := Rabs_pos l); assert (Q := Rabs_pos r).
  rewrite (Rabs_pos_eq (Rabs l + Rabs r)) in Sum by lra.
  assert (Ms : multiple (-384) (rnd (Rabs l + Rabs r)))
    by (apply rnd_multiple, multiple_sum; now apply multiple_absolute).
  set (s := rnd (Rabs l + Rabs r)) in *.
  destruct (rnd_error (-102 + -384) (orient2d_bound * s)) as [Er _]; [lia|apply multiple_product;
    [apply orient2d_bound_multiple|assumption]|].
  destruct (rnd_sum_error l (- r)) as [Df _]; [assumption|now apply opposite_is_double|].
  fold (l - r) in *.
  assert (S1 : (1 - u) * (Rabs l + Rabs r) <= s) by (unfold Rabs in Sum at 1; destruct Rcase_abs; lra).
  assert (B0 : 0 < orient2d_bound) by (unfold orient2d_bound; lra).
  assert (s0 : 0 <= s) by (apply Rle_trans with (2 := S1); apply Rmult_le_pos; lra).
  assert (S2 : (1 - u) * (orient2d_bound * s) <= rnd (orient2d_bound * s)).
  { rewrite (Rabs_pos_eq (orient2d_bound * s)) in Er by (apply Rmult_le_pos; lra).
    unfold Rabs in Er; destruct Rcase_abs; lra. }
  assert (S3 : Rabs (rnd (l - r)) <= (1 + u) * Rabs (l - r)).
  { replace (rnd (l - r)) with (rnd (l - r) - (l - r) + (l - r)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  (* the sign of l - r is that of the exact determinant *)
  assert (T : Rabs ((l - r) - E) <= ((1 + u) ^ 3 - 1) * (Rabs l + Rabs r)).
  { unfold E; replace (l - r - (AX * BY - AY * BX)) with (l - AX * BY + - (r - AY * BX)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (K : ((1 + u) ^ 3 - 1) * (1 + u) <= (1 - u) * orient2d_bound * (1 - u))
    by (unfold orient2d_bound, u; lra).
  assert (Chain : ((1 + u) ^ 3 - 1) * (1 + u) * (Rabs l + Rabs r) < (1 + u) * Rabs (l - r)).
  { apply Rle_lt_trans with ((1 - u) * orient2d_bound * (1 - u) * (Rabs l + Rabs r)).
    { apply Rmult_le_compat_r; lra. }
    apply Rle_lt_trans with ((1 - u) * (orient2d_bound * s)); [|lra].
    replace ((1 - u) * orient2d_bound * (1 - u) * (Rabs l + Rabs r))
      with ((1 - u) * orient2d_bound * ((1 - u) * (Rabs l + Rabs r))) by ring.
    replace ((1 - u) * (orient2d_bound * s)) with ((1 - u) * orient2d_bound * s) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|assumption]. }
  assert (Sg := same_sign (l - r) E).
  assert (Big : Rabs ((l - r) - E) < Rabs (l - r)).
  { apply Rle_lt_trans with (1 := T); apply Rmult_lt_reg_l with (1 + u); lra. }
  specialize (Sg Big).
  (* rounding keeps the sign of l - r *)
  assert (Rd : Rabs (l - r - rnd (l - r)) < Rabs (l - r)).
  { rewrite Rabs_minus_sym; apply Rle_lt_trans with (1 := Df).
    assert (0 <= Rabs ((l - r) - E)) by apply Rabs_pos.
    assert (u * Rabs (l - r) < 1 * Rabs (l - r)) by (apply Rmult_lt_compat_r; lra). lra. }
  assert (Sr := same_sign (l - r) (rnd (l - r)) Rd).
  destruct Sg, Sr; split; tauto.
Qed.

(* orient2d(): a certain sign is that of the exact determinant. *)
Theorem orient2d_filter : forall a_x a_y b_x b_y c_x c_y,
  usable a_x -> usable a_y -> usable b_x -> usable b_y -> usable c_x -> usable c_y ->
  let ax := rnd (a_x - c_x) in let ay := rnd (a_y - c_y) in let bx := rnd (b_x - c_x) in let by_ := rnd (b_y - c_y) in
  orientation_is_certain ax ay bx by_ ->
  let d := orientation_determinant ax ay bx by_ in
  let exact := (a_x - c_x) * (b_y - c_y) - (a_y - c_y) * (b_x - c_x) in
  (0 < d <-> 0 < exact) /\ (d < 0 <-> exact < 0).
Proof. intros; apply orientation_certain; try assumption; now apply difference. Qed.
