(* The arithmetic of is_outside_circle() in properties/checker/arithmetic/filter.hpp, and rounded comparisons. *)
From Pardel Require Import Rounding Constants CheckerFilter.

(* From an error and a size to a rounded comparison. *)
Lemma below_absolute : forall v' v e, Rabs (v' - v) <= e -> v' - e <= v <= v' + e.
Proof. intros v' v e H; unfold Rabs in H; destruct Rcase_abs in H; lra. Qed.

Lemma rnd_bounds : forall v, 0 <= v -> (1 - u) * v - eta <= rnd v <= (1 + u) * v + eta.
Proof.
  intros v V; assert (H := rnd_any_error v); fold eta in H; rewrite (Rabs_pos_eq v V) in H.
  apply below_absolute in H; lra.
Qed.

(* is_outside_circle(): p and q are the vectors to the ends of side 0 from the point d. *)
Section OutsideCircle.
  (* S is the exact sum of the squared sides, and the others are the numbers of the shape, rounded and exact. *)
  Variables shape_sum S shape_area area shape_dot dot_0 : R.
  Hypothesis S_large : / 2 ^ 301 <= S /\ 10000 * eta <= u * S.
  Hypothesis sum_close : (1 - 7 * u) * S <= shape_sum.
  Hypothesis area_close : close (404 / 100 * u) (S / 2) shape_area area.
  Hypothesis dot_close : close (404 / 100 * u) (S / 2) shape_dot dot_0.

  Variables px' px py' py qx' qx qy' qy : R.
  Hypothesis Px : difference_of px' px.
  Hypothesis Py : difference_of py' py.
  Hypothesis Qx : difference_of qx' qx.
  Hypothesis Qy : difference_of qy' qy.

  Definition circle_squares : R := rnd (length2 px' py' + length2 qx' qy').
  Definition circle_cross : R := cross2 qx' qy' px' py'.
  Definition circle_dot : R := dot2 px' py' qx' qy'.
  Definition circle_sine : R := rnd (rnd (shape_area * circle_dot) + rnd (shape_dot * circle_cross)).
  Let T : R := px ^ 2 + py ^ 2 + (qx ^ 2 + qy ^ 2).
  Let cross : R := qx * py - qy * px.
  Let dot : R := px * qx + py * qy.

  Hypothesis squares_large_enough : least_square <= circle_squares.

  Lemma squares_error : (1 - 503 / 100 * u) * T - 10 * eta <= circle_squares <= (1 + 503 / 100 * u) * T + 10 * eta.
  Proof.
    assert (U := u_value); destruct eta_value as [E0 _].
    assert (A := below_absolute _ _ _ (length_error _ _ _ _ Px Py)).
    assert (B := below_absolute _ _ _ (length_error _ _ _ _ Qx Qy)).
    destruct (rnd_sum_error (length2 px' py') (length2 qx' qy')) as [F _]; try apply rnd_is_double.
    fold circle_squares in F.
    assert (P : 0 <= px ^ 2 + py ^ 2) by (assert (X := pow2_ge_0 px); assert (Y := pow2_ge_0 py); lra).
    assert (Q : 0 <= qx ^ 2 + qy ^ 2) by (assert (X := pow2_ge_0 qx); assert (Y := pow2_ge_0 qy); lra).
    unfold T; set (a := px ^ 2 + py ^ 2) in *; set (b := qx ^ 2 + qy ^ 2) in *.
    set (v := length2 px' py') in *; set (w := length2 qx' qy') in *.
    assert (ua : 0 <= u * a) by (apply Rmult_le_pos; lra); assert (ub : 0 <= u * b) by (apply Rmult_le_pos; lra).
    assert (Va : u * a <= a / 100) by (assert (u * a <= / 100 * a) by (apply Rmult_le_compat_r; lra); lra).
    assert (Vb : u * b <= b / 100) by (assert (u * b <= / 100 * b) by (apply Rmult_le_compat_r; lra); lra).
    assert (Sab : Rabs (v + w) <= (1 + 402 / 100 * u) * (a + b) + 6 * eta)
      by (unfold Rabs; destruct Rcase_abs; lra).
    assert (K1 : u * Rabs (v + w) <= u * ((1 + 402 / 100 * u) * (a + b) + 6 * eta))
      by (apply Rmult_le_compat_l; lra).
    assert (u * (6 * eta) <= eta) by (assert (6 * u * eta <= 1 * eta) by (apply Rmult_le_compat_r; lra); lra).
    assert (u * (1 + 402 / 100 * u) * (a + b) <= 101 / 100 * u * (a + b))
      by (apply Rmult_le_compat_r; [lra|unfold u; lra]).
    apply below_absolute in F; lra.
  Qed.

  Lemma T_large : / 2 ^ 301 <= T /\ 10000 * eta <= u * T.
  Proof.
    assert (U := u_value); destruct eta_value as [E0 E1]; destruct squares_error as [_ H].
    assert (L := squares_large_enough); unfold least_square in L.
    assert (Ht : / 2 ^ 301 <= T).
    { assert (20 * eta <= / 2 ^ 310) by (unfold u in E1; lra).
      destruct (Rle_or_lt (/ 2 ^ 301) T) as [|N]; [assumption|exfalso].
      assert ((1 + 503 / 100 * u) * T <= (1 + 503 / 100 * u) * / 2 ^ 301) by (apply Rmult_le_compat_l; lra).
      unfold u in *; lra. }
    split; [assumption|]; assert (u * / 2 ^ 604 <= u * T) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Lemma sine_is_positive : rnd (rnd (circle_bound * shape_sum) * circle_squares) < circle_sine ->
    0 < area * dot + dot_0 * cross.
  Proof.
    intro H; assert (U := u_value); destruct eta_value as [E0 E1].
    destruct S_large as [S0 Es]; destruct T_large as [T0 Et].
    destruct squares_error as [Lt _].
    destruct (cross_error _ _ _ _ _ _ _ _ Qx Qy Px Py) as [C1 C2].
    destruct (dot_error _ _ _ _ _ _ _ _ Px Py Qx Qy) as [D1 D2].
    fold circle_cross in C2; fold cross in C1, C2; fold circle_dot in D2; fold dot in D1, D2.
    replace (qx ^ 2 + qy ^ 2 + (px ^ 2 + py ^ 2)) with T in C1, C2 by (unfold T; ring).
    fold T in D1, D2.
    assert (uS : 0 < u * S) by (apply Rmult_lt_0_compat; lra).
    assert (uT : 0 < u * T) by (apply Rmult_lt_0_compat; lra).
    assert (Kc : close (404 / 100 * u) (T / 2) circle_cross cross) by (split; lra).
    assert (Kd : close (404 / 100 * u) (T / 2) circle_dot dot) by (split; lra).
    destruct (close_any_product (404 / 100 * u) (404 / 100 * u) (909 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(lra)
                ltac:(unfold u; lra) area_close Kd) as [P1 P2].
    destruct (close_any_product (404 / 100 * u) (404 / 100 * u) (909 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(lra)
                ltac:(unfold u; lra) dot_close Kc) as [Q1 Q2].
    set (W := S / 2 * (T / 2)) in *.
    assert (W0 : / 2 ^ 604 <= W).
    { apply Rle_trans with (/ 2 ^ 301 / 2 * (/ 2 ^ 301 / 2)); [lra|]; apply Rmult_le_compat; lra. }
    assert (Ew : 1000000 * eta <= u * W) by (assert (u * / 2 ^ 604 <= u * W) by (apply Rmult_le_compat_l; lra); lra).
    assert (uW : 0 < u * W) by (apply Rmult_lt_0_compat; lra).
    assert (Kp : close (910 / 100 * u) W (rnd (shape_area * circle_dot)) (area * dot)) by (split; lra).
    assert (Kq : close (910 / 100 * u) W (rnd (shape_dot * circle_cross)) (dot_0 * cross)) by (split; lra).
    destruct (close_sum (910 / 100 * u) (1011 / 100 * u) _ _ _ _ _ _ ltac:(lra) ltac:(unfold u; lra)
                (rnd_is_double _) (rnd_is_double _) Kp Kq) as [_ K].
    fold circle_sine in K; apply below_absolute in K.
    (* the threshold *)
    assert (Sl := sum_close); assert (Tl : (1 - 7 * u) * T <= circle_squares) by lra.
    assert (Sp : 0 < (1 - 7 * u) * S) by (apply Rmult_lt_0_compat; lra).
    assert (Tp : 0 < (1 - 7 * u) * T) by (apply Rmult_lt_0_compat; lra).
    assert (B0 : 0 < circle_bound) by (unfold circle_bound; lra).
    assert (G : circle_bound * ((1 - 7 * u) * S) <= circle_bound * shape_sum) by (apply Rmult_le_compat_l; lra).
    assert (G0 : 0 < circle_bound * ((1 - 7 * u) * S)) by now apply Rmult_lt_0_compat.
    destruct (rnd_bounds (circle_bound * shape_sum)) as [R1 _]; [lra|].
    set (y := rnd (circle_bound * shape_sum)) in *.
    assert (Y : 549 / 100 * u * S <= y).
    { assert ((1 - u) * (circle_bound * ((1 - 7 * u) * S)) <= (1 - u) * (circle_bound * shape_sum))
        by (apply Rmult_le_compat_l; lra).
      assert (5499 / 1000 * u * S <= (1 - u) * (circle_bound * ((1 - 7 * u) * S))).
      { replace ((1 - u) * (circle_bound * ((1 - 7 * u) * S))) with ((1 - u) * circle_bound * (1 - 7 * u) * S) by ring.
        apply Rmult_le_compat_r; [lra|unfold circle_bound, u; lra]. }
      lra. }
    assert (Z : 549 / 100 * u * S * ((1 - 7 * u) * T) <= y * circle_squares) by (apply Rmult_le_compat; lra).
    assert (Z0 : 0 < 549 / 100 * u * S * ((1 - 7 * u) * T)) by (apply Rmult_lt_0_compat; lra).
    destruct (rnd_bounds (y * circle_squares)) as [R2 _]; [lra|].
    assert (Z2 : (1 - u) * (549 / 100 * u * S * ((1 - 7 * u) * T)) <= (1 - u) * (y * circle_squares))
      by (apply Rmult_le_compat_l; lra).
    assert (Z3 : 2190 / 100 * u * W <= (1 - u) * (549 / 100 * u * S * ((1 - 7 * u) * T))).
    { replace ((1 - u) * (549 / 100 * u * S * ((1 - 7 * u) * T)))
        with ((1 - u) * (2196 / 100 * u) * (1 - 7 * u) * W) by (unfold W; field).
      apply Rmult_le_compat_r; [lra|unfold u; lra]. }
    lra.
  Qed.
End OutsideCircle.
