(* The filter of incircle() in parallel/arithmetic/predicates.hpp: if is_certain() answers `true`, the sign is that of
   the exact determinant. *)
From Pardel Require Import Rounding Constants OrientationFilter.

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
