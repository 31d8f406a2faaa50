(* The bound of T3-sharp of THEORY.md: it grows with the ratio, and isosceles triangles attain it. *)
From Pardel Require Import Plane LeastArea QuarticBound RatioAndArea.

(* T3-sharp: the bound grows with the ratio, from 1 / sqrt 3 on. *)
Theorem sharp_bound_grows : forall rho rho' delta, 0 < delta -> 1 / sqrt 3 <= rho -> rho < rho' ->
  sharp_bound rho delta < sharp_bound rho' delta.
Proof.
  intros u v delta D Hu Huv.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (U2 : 1 / 3 <= u ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  assert (UV : u ^ 2 < v ^ 2) by nra.
  assert (G := quartic_grows _ _ U2 UV); unfold sharp_bound.
  destruct (fourth_root (4 * u ^ 2 - 1)) as [A0 A]; [lra|].
  destruct (fourth_root (4 * v ^ 2 - 1)) as [B0 B]; [lra|].
  set (a := Rpower (4 * u ^ 2 - 1) (1 / 4)) in *; set (b := Rpower (4 * v ^ 2 - 1) (1 / 4)) in *.
  assert (E := sqrt_lt_R0 delta D).
  assert (L : u ^ 2 * b < v ^ 2 * a).
  { destruct (Rlt_or_le (u ^ 2 * b) (v ^ 2 * a)) as [|N]; [assumption|exfalso].
    assert (0 <= v ^ 2 * a) by (apply Rmult_le_pos; lra).
    assert (F := pow_incr _ _ 4 (conj H N)); rewrite !Rpow_mult_distr, A, B in F; lra. }
  apply Rmult_lt_reg_r with (a * b); [now apply Rmult_lt_0_compat|].
  replace (2 * u ^ 2 * sqrt delta / a * (a * b)) with (2 * sqrt delta * (u ^ 2 * b)) by (field; lra).
  replace (2 * v ^ 2 * sqrt delta / b * (a * b)) with (2 * sqrt delta * (v ^ 2 * a)) by (field; lra).
  apply Rmult_lt_compat_l; lra.
Qed.

(* T3-sharp: at every ratio from 1 / sqrt 3 on and every area, an isosceles triangle attains the bound. *)
Theorem isosceles_triangle_attains_the_sharp_bound : forall rho delta, 1 / sqrt 3 <= rho -> 0 < delta ->
  exists a b c o, triangle a b c /\ circumcircle a b c o (sharp_bound rho delta) /\
    ratio a b c (sharp_bound rho delta) = rho /\ area a b c = delta /\ two_edges_are_shortest a b c.
Proof.
  intros rho delta Hr D.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (R2 : 1 / 3 <= rho ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  set (g := sqrt (4 * rho ^ 2 - 1)).
  assert (G : 0 < g) by (apply sqrt_lt_R0; lra).
  assert (G2 : g ^ 2 = 4 * rho ^ 2 - 1) by (apply pow2_sqrt; lra).
  set (k := sqrt (delta / g)).
  assert (K : 0 < k) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; assumption).
  assert (K2 : k ^ 2 = delta / g) by (apply pow2_sqrt; left; apply Rdiv_lt_0_compat; assumption).
  assert (Area : k ^ 2 * g = delta) by (rewrite K2; field; lra).
  set (a := (0, k) : point); set (b := (- (k * g), 0) : point); set (c := (k * g, 0) : point).
  set (r := 2 * rho ^ 2 * k); set (o := (0, k - r) : point).
  assert (KG : 0 < k * g) by now apply Rmult_lt_0_compat.
  assert (L : k ^ 2 + (k * g) ^ 2 = (2 * rho * k) ^ 2) by (rewrite !Rpow_mult_distr, G2; ring).
  assert (Dab : distance a b = 2 * rho * k).
  { unfold distance, square_distance, a, b; cbn [fst snd].
    replace ((- (k * g) - 0) ^ 2 + (0 - k) ^ 2) with (k ^ 2 + (k * g) ^ 2) by ring; rewrite L.
    apply sqrt_pow2; apply Rmult_le_pos; lra. }
  assert (Dca : distance c a = 2 * rho * k).
  { unfold distance, square_distance, a, c; cbn [fst snd].
    replace ((0 - k * g) ^ 2 + (k - 0) ^ 2) with (k ^ 2 + (k * g) ^ 2) by ring; rewrite L.
    apply sqrt_pow2; apply Rmult_le_pos; lra. }
  assert (Dbc : distance b c = 2 * (k * g)).
  { unfold distance, square_distance, b, c; cbn [fst snd].
    replace ((k * g - - (k * g)) ^ 2 + (0 - 0) ^ 2) with ((2 * (k * g)) ^ 2) by ring.
    apply sqrt_pow2; lra. }
  assert (Le : rho <= g) by (apply at_most_of_squares; [lra|rewrite G2; lra]).
  assert (Short : shortest_edge a b c = 2 * rho * k).
  { unfold shortest_edge; rewrite Dab, Dbc, Dca.
    assert (2 * rho * k <= 2 * (k * g)) by nra.
    unfold Rmin; repeat destruct Rle_dec; lra. }
  assert (RK : 0 < rho * k) by (apply Rmult_lt_0_compat; lra).
  assert (Ra : 0 < r) by (unfold r; nra).
  assert (T : triangle a b c) by (unfold triangle, twice_area, a, b, c; cbn [fst snd]; nra).
  assert (A : area a b c = delta)
    by (unfold area, twice_area, a, b, c; cbn [fst snd]; rewrite <- Area; field).
  assert (Q : ratio a b c r = rho) by (unfold ratio, r; rewrite Short; field; lra).
  assert (C : circumcircle a b c o r).
  { assert (W : (k * g) ^ 2 + (k - r) ^ 2 = r ^ 2)
      by (replace ((k - r) ^ 2) with (k ^ 2 - 2 * k * r + r ^ 2) by ring;
          replace ((k * g) ^ 2) with ((2 * rho * k) ^ 2 - k ^ 2) by lra; unfold r; ring).
    repeat split; unfold on_circle, distance, square_distance, o, a, b, c; cbn [fst snd];
      rewrite <- (sqrt_pow2 r) at 2 by lra; f_equal; lra. }
  assert (I : two_edges_are_shortest a b c) by (right; right; rewrite Short; split; assumption).
  assert (E : r = sharp_bound rho delta)
    by (apply (T3_sharp_equality a b c o r rho delta T C); [lra|lra|tauto]).
  exists a, b, c, o; rewrite <- E; tauto.
Qed.

(* T3: a bound with sqrt 2 in place of 2 is false at every ratio. *)
Theorem T3_with_root_two_is_false : forall rho delta, 1 / sqrt 3 <= rho -> 0 < delta ->
  sqrt 2 * Rpower rho (3 / 2) * sqrt delta < sharp_bound rho delta.
Proof.
  intros rho delta Hr D.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (R2 : 1 / 3 <= rho ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  unfold sharp_bound.
  destruct (fourth_root (4 * rho ^ 2 - 1)) as [A0 A]; [lra|].
  destruct (power_three_halves rho) as [B0 B]; [lra|].
  set (w := Rpower (4 * rho ^ 2 - 1) (1 / 4)) in *; set (v := Rpower rho (3 / 2)) in *.
  assert (E := sqrt_lt_R0 delta D); assert (T := sqrt_lt_R0 2 ltac:(lra)); assert (T2 := pow2_sqrt 2 ltac:(lra)).
  apply Rmult_lt_reg_r with (w / sqrt delta); [now apply Rdiv_lt_0_compat|].
  replace (2 * rho ^ 2 * sqrt delta / w * (w / sqrt delta)) with (2 * rho ^ 2) by (field; lra).
  replace (sqrt 2 * v * sqrt delta * (w / sqrt delta)) with (sqrt 2 * v * w) by (field; lra).
  destruct (Rlt_or_le (sqrt 2 * v * w) (2 * rho ^ 2)) as [|N]; [assumption|exfalso].
  assert (N0 : 0 <= 2 * rho ^ 2) by lra.
  assert (F := pow_incr _ _ 4 (conj N0 N)).
  replace ((sqrt 2 * v * w) ^ 4) with ((sqrt 2 ^ 2) ^ 2 * (v ^ 2) ^ 2 * w ^ 4) in F by ring.
  rewrite T2, A, B in F; assert (0 < rho ^ 6) by (apply pow_lt; lra).
  replace ((2 * rho ^ 2) ^ 4) with (16 * rho ^ 2 * rho ^ 6) in F by ring.
  replace (2 ^ 2 * (rho ^ 3) ^ 2 * (4 * rho ^ 2 - 1)) with (16 * rho ^ 2 * rho ^ 6 - 4 * rho ^ 6) in F by ring.
  lra.
Qed.
