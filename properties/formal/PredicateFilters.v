(* The filters of parallel/arithmetic/predicates.hpp: if is_certain() answers `true`, the sign is that of the exact
   determinant. Constants.v has the constants of the source. *)
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

(* InCircle<double>(ux, uy, vx, vy, wx, wy, u2, v2). *)
Section InCircle.
  Variables ux uy vx vy wx wy u2 v2 : R.
  Definition incircle_square : R := rnd (rnd (wx * wx) + rnd (wy * wy)).
  Definition incircle_determinant : R :=
    rnd (rnd (incircle_square * rnd (rnd (vx * uy) - rnd (vy * ux)))
         + rnd (rnd (wx * rnd (rnd (u2 * vy) - rnd (v2 * uy))) - rnd (wy * rnd (rnd (u2 * vx) - rnd (v2 * ux))))).
  Definition incircle_error : R :=
    rnd (incircle_bound * rnd (rnd (u2 * v2) + rnd (incircle_square * rnd (u2 + v2)))).
  Definition incircle_is_certain : Prop := incircle_error < Rabs incircle_determinant.
End InCircle.

(* Twice the absolute value of a product is at most the sum of the squares. *)
Lemma product_below_squares : forall v w, Rabs v * Rabs w <= (v ^ 2 + w ^ 2) / 2.
Proof.
  intros v w; rewrite <- Rabs_mult; assert (0 <= (v - w) ^ 2) by apply pow2_ge_0.
  assert (0 <= (v + w) ^ 2) by apply pow2_ge_0; unfold Rabs; destruct Rcase_abs; lra.
Qed.

(* Half of a determinant: products of four coordinates, and the bound on their sum. *)
Lemma sum_of_products : forall U V W U2 V2 W2 x y z x' y' z',
  U2 = x ^ 2 + x' ^ 2 -> V2 = y ^ 2 + y' ^ 2 -> W2 = z ^ 2 + z' ^ 2 -> U = U2 -> V = V2 -> W = W2 ->
  W2 * (Rabs y * Rabs x' + Rabs y' * Rabs x) +
  (Rabs z * (U2 * Rabs y' + V2 * Rabs x') + Rabs z' * (U2 * Rabs y + V2 * Rabs x)) <= U * V + W * (U + V).
Proof.
  intros U V W U2 V2 W2 x y z x' y' z' Eu Ev Ew -> -> ->.
  assert (P : forall s t s' t', Rabs s * Rabs t' + Rabs s' * Rabs t <= (s ^ 2 + s' ^ 2 + (t ^ 2 + t' ^ 2)) / 2).
  { intros s t s' t'; assert (A := product_below_squares s t'); assert (B := product_below_squares s' t); lra. }
  assert (A := P y x y' x'); assert (B := P z y z' y'); assert (C := P z x z' x').
  rewrite <- Eu, <- Ev in A; rewrite <- Ev, <- Ew in B; rewrite <- Eu, <- Ew in C.
  assert (Q : forall s t, 0 <= s ^ 2 + t ^ 2) by (intros s t; assert (X := pow2_ge_0 s); assert (Y := pow2_ge_0 t); lra).
  assert (U0 : 0 <= U2) by (rewrite Eu; apply Q); assert (V0 : 0 <= V2) by (rewrite Ev; apply Q).
  assert (W0 : 0 <= W2) by (rewrite Ew; apply Q).
  apply Rmult_le_compat_l with (r := W2) in A; [|assumption].
  apply Rmult_le_compat_l with (r := U2) in B; [|assumption].
  apply Rmult_le_compat_l with (r := V2) in C; [|assumption].
  lra.
Qed.

Ltac double := apply rnd_is_double.

(* A product and a sum of two products of coordinates, with the errors of the comment in the source. *)
Lemma squared_length : forall x' x y' y, coordinate x' x -> coordinate y' y ->
  let s := rnd (rnd (x' * x') + rnd (y' * y')) in
  is_double s /\ multiple (-384) s /\ close (402 / 100 * u) (x ^ 2 + y ^ 2) s (x ^ 2 + y ^ 2).
Proof.
  intros x' x y' y X Y s; assert (U := u_value); split; [double|]; split.
  - apply rnd_multiple, multiple_sum; apply rnd_multiple; change (-384)%Z with (-192 + -192)%Z;
      apply multiple_product; first [apply X|apply Y].
  - assert (One : forall z' z, coordinate z' z -> close (301 / 100 * u) (z ^ 2) (rnd (z' * z')) (z ^ 2)).
    { intros z' z Z; replace (z ^ 2) with (Rabs z * Rabs z) at 1
        by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring|replace (z * z) with (z ^ 2) by ring; apply pow2_ge_0]).
      replace (z ^ 2) with (z * z) by ring.
      apply (close_product (-192) (-192) u u); try apply Z; try lra; try lia; unfold u; lra. }
    apply (close_sum (301 / 100 * u)); try double; try lra; [unfold u; lra|now apply One|now apply One].
Qed.

Lemma incircle_bound_multiple : multiple (-53) incircle_bound.
Proof.
  apply generic_format_FIX; exists (Float radix2 12 (-53)); [|reflexivity].
  unfold incircle_bound, F2R; simpl; lra.
Qed.

Lemma incircle_certain : forall ux uy vx vy wx wy u2 v2 UX UY VX VY WX WY,
  coordinate ux UX -> coordinate uy UY -> coordinate vx VX -> coordinate vy VY ->
  coordinate wx WX -> coordinate wy WY ->
  u2 = rnd (rnd (ux * ux) + rnd (uy * uy)) -> v2 = rnd (rnd (vx * vx) + rnd (vy * vy)) ->
  incircle_is_certain ux uy vx vy wx wy u2 v2 ->
  let d := incircle_determinant ux uy vx vy wx wy u2 v2 in
  let D := (WX ^ 2 + WY ^ 2) * (VX * UY - VY * UX) +
           (WX * ((UX ^ 2 + UY ^ 2) * VY - (VX ^ 2 + VY ^ 2) * UY) -
            WY * ((UX ^ 2 + UY ^ 2) * VX - (VX ^ 2 + VY ^ 2) * UX)) in
  (0 < d <-> 0 < D) /\ (d < 0 <-> D < 0).
Proof.
  intros ux uy vx vy wx wy u2 v2 UX UY VX VY WX WY Cux Cuy Cvx Cvy Cwx Cwy E2 F2 S; assert (U := u_value).
  unfold incircle_is_certain, incircle_error, incircle_determinant in *.
  destruct (squared_length _ _ _ _ Cux Cuy) as (Fu & Mu & Ku); rewrite <- E2 in *.
  destruct (squared_length _ _ _ _ Cvx Cvy) as (Fv & Mv & Kv); rewrite <- F2 in *.
  destruct (squared_length _ _ _ _ Cwx Cwy) as (Fw & Mw & Kw); fold (incircle_square wx wy) in *.
  set (w2 := incircle_square wx wy) in *; clearbody w2; clear E2 F2.
  assert (Su := eq_refl (UX ^ 2 + UY ^ 2)); set (U2 := UX ^ 2 + UY ^ 2) in *.
  assert (Sv := eq_refl (VX ^ 2 + VY ^ 2)); set (V2 := VX ^ 2 + VY ^ 2) in *.
  assert (Sw := eq_refl (WX ^ 2 + WY ^ 2)); set (W2 := WX ^ 2 + WY ^ 2) in *.
  (* the cross product of u and v *)
  assert (Kc : close (402 / 100 * u) (Rabs VX * Rabs UY + Rabs VY * Rabs UX)
                 (rnd (rnd (vx * uy) - rnd (vy * ux))) (VX * UY - VY * UX)).
  { apply (close_difference (301 / 100 * u)); try double; try lra; [unfold u; lra| |];
      apply (close_product (-192) (-192) u u); try apply Cux; try apply Cuy; try apply Cvx; try apply Cvy; try lra;
      try lia; unfold u; lra. }
  assert (Mc : multiple (-384) (rnd (rnd (vx * uy) - rnd (vy * ux)))).
  { apply rnd_multiple, multiple_sum; [|apply multiple_opposite]; apply rnd_multiple;
      change (-384)%Z with (-192 + -192)%Z; apply multiple_product; first [apply Cux|apply Cuy|apply Cvx|apply Cvy]. }
  (* w2 (v x u) *)
  assert (Kt : close (1006 / 100 * u) (W2 * (Rabs VX * Rabs UY + Rabs VY * Rabs UX))
                 (rnd (w2 * rnd (rnd (vx * uy) - rnd (vy * ux)))) (W2 * (VX * UY - VY * UX))).
  { apply (close_product (-384) (-384) (402 / 100 * u) (402 / 100 * u)); try assumption; try lra; try lia;
      unfold u; lra. }
  (* u2 vy - v2 uy and u2 vx - v2 ux *)
  assert (Inner : forall s' s t' t, coordinate s' s -> coordinate t' t ->
    let e := rnd (rnd (u2 * t') - rnd (v2 * s')) in
    multiple (-576) e /\ close (704 / 100 * u) (U2 * Rabs t + V2 * Rabs s) e (U2 * t - V2 * s)).
  { intros s' s t' t Cs Ct e; split.
    - apply rnd_multiple, multiple_sum; [|apply multiple_opposite]; apply rnd_multiple;
        change (-576)%Z with (-384 + -192)%Z; apply multiple_product; first [assumption|apply Cs|apply Ct].
    - apply (close_difference (603 / 100 * u)); try double; try lra; [unfold u; lra| |];
        apply (close_product (-384) (-192) (402 / 100 * u) u); try assumption; try apply Cs; try apply Ct; try lra;
        try lia; unfold u; lra. }
  destruct (Inner _ _ _ _ Cuy Cvy) as [My Ky]; destruct (Inner _ _ _ _ Cux Cvx) as [Mx Kx].
  assert (Outer : forall z' z e E m, coordinate z' z -> multiple (-576) e -> close (704 / 100 * u) m e E ->
    close (905 / 100 * u) (Rabs z * m) (rnd (z' * e)) (z * E)).
  { intros z' z e E m Z M K; apply (close_product (-192) (-576) u (704 / 100 * u)); try assumption; try apply Z; try lra;
      try lia; unfold u; lra. }
  assert (Kd := Outer _ _ _ _ _ Cwx My Ky); assert (Ke := Outer _ _ _ _ _ Cwy Mx Kx).
  assert (Kf := close_difference (905 / 100 * u) (1006 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(unfold u; lra)
                  (rnd_is_double _) (rnd_is_double _) Kd Ke).
  assert (Kg := close_sum (1006 / 100 * u) (1107 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(unfold u; lra)
                  (rnd_is_double _) (rnd_is_double _) Kt Kf).
  (* the sum of the absolute values is at most T *)
  set (T := U2 * V2 + W2 * (U2 + V2)).
  assert (Le := sum_of_products U2 V2 W2 U2 V2 W2 UX VX WX UY VY WY Su Sv Sw eq_refl eq_refl eq_refl); fold T in Le.
  apply close_larger with (m' := T) in Kg; [|lra|exact Le].
  (* the computed T *)
  assert (Nu : 0 <= U2) by (destruct Ku as [Ku _]; apply Rle_trans with (2 := Ku); apply Rabs_pos).
  assert (Kuv := close_product (-384) (-384) (402 / 100 * u) (402 / 100 * u) (1006 / 100 * u) _ _ _ _ _ _ ltac:(lra)
                   ltac:(lra) ltac:(unfold u; lra) Mu Mv ltac:(lia) Ku Kv).
  assert (Ks := close_sum (402 / 100 * u) (503 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(unfold u; lra) Fu Fv Ku Kv).
  assert (Ms : multiple (-384) (rnd (u2 + v2))) by (apply rnd_multiple; now apply multiple_sum).
  assert (Kws := close_product (-384) (-384) (402 / 100 * u) (503 / 100 * u) (1006 / 100 * u) _ _ _ _ _ _ ltac:(lra)
                   ltac:(lra) ltac:(unfold u; lra) Mw Ms ltac:(lia) Kw Ks).
  assert (KT := close_sum (1006 / 100 * u) (1107 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(unfold u; lra)
                  (rnd_is_double _) (rnd_is_double _) Kuv Kws); fold T in KT.
  assert (MT : multiple (-768) (rnd (rnd (u2 * v2) + rnd (w2 * rnd (u2 + v2))))).
  { apply rnd_multiple, multiple_sum; apply rnd_multiple; change (-768)%Z with (-384 + -384)%Z;
      now apply multiple_product. }
  destruct (rnd_error (-53 + -768) (incircle_bound * rnd (rnd (u2 * v2) + rnd (w2 * rnd (u2 + v2))))) as [Er _];
    [lia|apply multiple_product; [apply incircle_bound_multiple|assumption]|].
  set (t := rnd (rnd (u2 * v2) + rnd (w2 * rnd (u2 + v2)))) in *.
  assert (T0 : 0 <= T) by (destruct KT as [KT _]; apply Rle_trans with (2 := KT); apply Rabs_pos).
  assert (Tt : (1 - 1107 / 100 * u) * T <= t).
  { destruct KT as [_ KT]; assert (Pos : 0 <= U2 * V2 + W2 * (U2 + V2)) by exact T0.
    fold T in KT; unfold Rabs in KT; destruct Rcase_abs in KT; lra. }
  assert (B0 : 0 < incircle_bound) by (unfold incircle_bound; lra).
  assert (t0 : 0 <= t) by (apply Rle_trans with (2 := Tt); apply Rmult_le_pos; lra).
  assert (Er2 : (1 - u) * (incircle_bound * t) <= rnd (incircle_bound * t)).
  { rewrite (Rabs_pos_eq (incircle_bound * t)) in Er by (apply Rmult_le_pos; lra).
    unfold Rabs in Er; destruct Rcase_abs in Er; lra. }
  apply same_sign; destruct Kg as [_ Kg].
  apply Rle_lt_trans with (1 := Kg); apply Rle_lt_trans with (2 := S).
  apply Rle_trans with (2 := Er2).
  apply Rle_trans with ((1 - u) * (incircle_bound * ((1 - 1107 / 100 * u) * T))).
  - replace ((1 - u) * (incircle_bound * ((1 - 1107 / 100 * u) * T)))
      with ((1 - u) * incircle_bound * (1 - 1107 / 100 * u) * T) by ring.
    apply Rmult_le_compat_r; [assumption|unfold incircle_bound, u; lra].
  - apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra.
Qed.

(* incircle(): a certain sign is that of the exact determinant, which is positive if a, b, c are counter-clockwise and d
   lies inside their circumcircle. *)
Theorem incircle_filter : forall a_x a_y b_x b_y c_x c_y d_x d_y,
  usable a_x -> usable a_y -> usable b_x -> usable b_y -> usable c_x -> usable c_y -> usable d_x -> usable d_y ->
  let ax := rnd (a_x - d_x) in let ay := rnd (a_y - d_y) in let bx := rnd (b_x - d_x) in let by_ := rnd (b_y - d_y) in
  let cx := rnd (c_x - d_x) in let cy := rnd (c_y - d_y) in
  let b2 := rnd (rnd (bx * bx) + rnd (by_ * by_)) in let a2 := rnd (rnd (ax * ax) + rnd (ay * ay)) in
  incircle_is_certain bx by_ ax ay cx cy b2 a2 ->
  let d := incircle_determinant bx by_ ax ay cx cy b2 a2 in
  let AX := a_x - d_x in let AY := a_y - d_y in let BX := b_x - d_x in let BY := b_y - d_y in
  let CX := c_x - d_x in let CY := c_y - d_y in
  let exact := (AX ^ 2 + AY ^ 2) * (BX * CY - BY * CX) + (BX ^ 2 + BY ^ 2) * (CX * AY - CY * AX) +
               (CX ^ 2 + CY ^ 2) * (AX * BY - AY * BX) in
  (0 < d <-> 0 < exact) /\ (d < 0 <-> exact < 0).
Proof.
  intros a_x a_y b_x b_y c_x c_y d_x d_y Ax Ay Bx By_ Cx Cy Dx Dy ax ay bx by_ cx cy b2 a2 S d AX AY BX BY CX CY E.
  assert (H := incircle_certain bx by_ ax ay cx cy b2 a2 BX BY AX AY CX CY
    (difference _ _ Bx Dx) (difference _ _ By_ Dy) (difference _ _ Ax Dx) (difference _ _ Ay Dy)
    (difference _ _ Cx Dx) (difference _ _ Cy Dy) eq_refl eq_refl S).
  cbv zeta in H; fold d in H; unfold E.
  replace ((AX ^ 2 + AY ^ 2) * (BX * CY - BY * CX) + (BX ^ 2 + BY ^ 2) * (CX * AY - CY * AX) +
           (CX ^ 2 + CY ^ 2) * (AX * BY - AY * BX))
    with ((CX ^ 2 + CY ^ 2) * (AX * BY - AY * BX) +
          (CX * ((BX ^ 2 + BY ^ 2) * AY - (AX ^ 2 + AY ^ 2) * BY) -
           CY * ((BX ^ 2 + BY ^ 2) * AX - (AX ^ 2 + AY ^ 2) * BX))) by ring.
  exact H.
Qed.
