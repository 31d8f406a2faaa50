(* T2-once of THEORY.md: the bound on the circumradius of a new triangle at an encroached wall. There are two cases: (i)
   the two segments have no common point, (ii) they meet in a corner. r0 is the bound on all circumradii. *)
From Pardel Require Import Plane Pencil Lemma5 Growth.

(* The point of the segment mn at the fraction k. *)
Definition on_segment (m n : point) (k : R) : point := (m.x + k * (n.x - m.x), m.y + k * (n.y - m.y)).

(* (i), in numbers: a is half the length of the wall, h the distance of p from its line, and q the square of the distance
   of p from its perpendicular bisector. Then (|mp| |np|)^2 = (q + a^2 + h^2)^2 - 4 a^2 q. *)
Lemma product_largest_at_the_bisector : forall a h q, 0 <= q -> q <= a ^ 2 - h ^ 2 ->
  (q + a ^ 2 + h ^ 2) ^ 2 - 4 * a ^ 2 * q <= (a ^ 2 + h ^ 2) ^ 2.
Proof.
  intros a h q Q0 Q1.
  assert (0 <= q * (2 * a ^ 2 - 2 * h ^ 2 - q)).
  { apply Rmult_le_pos; [assumption|]; assert (0 <= a ^ 2 - h ^ 2) by lra; lra. }
  lra.
Qed.

(* (a^2 + h^2) / (2 h) falls in h for h < a and grows in a. *)
Lemma largest_at_the_ends : forall a h r0 lambda, 0 < lambda -> lambda <= h -> h < a -> a <= r0 ->
  (a ^ 2 + h ^ 2) / (2 * h) <= r0 * ((r0 / lambda + lambda / r0) / 2).
Proof.
  intros a h r0 lambda L H A R.
  replace (r0 * ((r0 / lambda + lambda / r0) / 2)) with ((r0 ^ 2 + lambda ^ 2) / (2 * lambda)) by (field; lra).
  apply Rmult_le_reg_r with (2 * h * lambda); [apply Rmult_lt_0_compat; lra|].
  replace ((a ^ 2 + h ^ 2) / (2 * h) * (2 * h * lambda)) with ((a ^ 2 + h ^ 2) * lambda) by (field; lra).
  replace ((r0 ^ 2 + lambda ^ 2) / (2 * lambda) * (2 * h * lambda)) with ((r0 ^ 2 + lambda ^ 2) * h) by (field; lra).
  assert (a ^ 2 <= r0 ^ 2) by (apply pow_incr; lra).
  assert (a ^ 2 * h <= r0 ^ 2 * h) by (apply Rmult_le_compat_r; lra).
  assert (0 <= (h - lambda) * (a ^ 2 - h * lambda)).
  { apply Rmult_le_pos; [lra|]; assert (h * lambda <= h * h) by (apply Rmult_le_compat_l; lra).
    assert (h * h <= a * a) by (apply Rmult_le_compat; lra). lra. }
  lra.
Qed.

(* T2-once, (i). The wall mn has at most the length 2 r0, p encroaches upon it, and no point of the wall is nearer to
   p than lambda. *)
Theorem T2_once_i : forall r0 lambda m n p o r,
  0 < lambda -> triangle m n p -> circumcircle m n p o r ->
  distance m n <= 2 * r0 -> in_diametral_circle m n p ->
  (forall k, 0 <= k <= 1 -> lambda <= distance p (on_segment m n k)) ->
  lambda < r0 /\ r <= r0 * ((r0 / lambda + lambda / r0) / 2).
Proof.
  intros r0 lambda m n p o r L T C M I Far.
  assert (D := edge_positive m n p T); assert (D2 := distance_squared m n).
  assert (H := height_on_the_left m n p T).
  rewrite in_diametral_circle_is_obtuse in I.
  set (d := distance m n) in *; set (h := height m n p) in *.
  (* the foot of p on the line is m + k (n - m) *)
  set (e := (n.x - m.x) * (p.x - m.x) + (n.y - m.y) * (p.y - m.y)).
  assert (Split : dot_at p m n = (e ^ 2 - d ^ 2 * e) / d ^ 2 + h ^ 2).
  { unfold h, height; fold d; unfold Rdiv; rewrite Rpow_mult_distr, pow_inv.
    apply Rmult_eq_reg_l with (d ^ 2); [|apply Rgt_not_eq, pow_lt; assumption].
    replace (d ^ 2 * ((e ^ 2 - d ^ 2 * e) * / d ^ 2 + twice_area m n p ^ 2 * / d ^ 2))
      with (e ^ 2 - d ^ 2 * e + twice_area m n p ^ 2) by (field; lra).
    rewrite D2; unfold e, square_distance, dot_at, twice_area; ring. }
  assert (Pd : 0 < d ^ 2) by now apply pow_lt.
  set (k := e / d ^ 2); assert (Ek : e = k * d ^ 2) by (unfold k; field; lra).
  assert (Split' : dot_at p m n = d ^ 2 * (k ^ 2 - k) + h ^ 2) by (rewrite Split, Ek; field; lra).
  assert (Hh : 0 < h ^ 2) by now apply pow_lt.
  assert (Hk : k ^ 2 - k < 0).
  { apply Rmult_lt_reg_l with (d ^ 2); [assumption|]; lra. }
  assert (K : 0 <= k <= 1) by (split; nra).
  assert (Foot : square_distance p (on_segment m n k) = h ^ 2).
  { apply Rmult_eq_reg_l with (d ^ 2); [|lra].
    replace (d ^ 2 * h ^ 2) with (twice_area m n p ^ 2) by (unfold h, height; fold d; field; lra).
    assert (E2 : e ^ 2 + twice_area m n p ^ 2 = square_distance m p * d ^ 2)
      by (rewrite D2; unfold e, twice_area, square_distance; ring).
    replace (square_distance p (on_segment m n k)) with (square_distance m p - 2 * k * e + k ^ 2 * d ^ 2)
      by (rewrite D2; unfold e, on_segment, square_distance; cbn [fst snd]; ring).
    replace (twice_area m n p ^ 2) with (square_distance m p * d ^ 2 - e ^ 2) by lra; rewrite Ek; ring. }
  assert (Lh : lambda <= h).
  { apply at_most_of_squares; [lra|]; rewrite <- Foot, <- distance_squared; apply pow_incr; split; [lra|].
    now apply Far. }
  set (a := d / 2); assert (Ea : d = 2 * a) by (unfold a; field).
  (* the square of the distance of p from the bisector is q *)
  set (q := (k - 1 / 2) ^ 2 * d ^ 2).
  assert (Q0 : 0 <= q) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (Q1 : q < a ^ 2 - h ^ 2).
  { rewrite Split' in I; unfold q, a; replace ((k - 1 / 2) ^ 2 * d ^ 2) with (d ^ 2 * (k ^ 2 - k) + (d / 2) ^ 2) by field.
    lra. }
  assert (A : h < a) by (apply below_of_squares; unfold a in *; lra).
  split; [unfold a in *; lra|].
  assert (B := product_largest_at_the_bisector a h q Q0 ltac:(lra)).
  apply Rle_trans with ((a ^ 2 + h ^ 2) / (2 * h)); [|apply largest_at_the_ends; unfold a in *; lra].
  assert (Nr := circle_radius_nonnegative m n o r (edge_of_circumcircle m n p o r C)).
  assert (F := circumradius_formula m n p o r C).
  assert (Prod : square_distance n p * square_distance p m = (q + a ^ 2 + h ^ 2) ^ 2 - 4 * a ^ 2 * q).
  { rewrite (square_distance_symmetric n p), Rmult_comm, lagrange, Split'.
    replace (twice_area m n p) with (h * d) by (unfold h, height; fold d; field; lra).
    unfold q, a; field. }
  assert (Area : twice_area m n p ^ 2 = h ^ 2 * d ^ 2) by (unfold h, height; fold d; field; lra).
  apply at_most_of_squares; [apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra]|].
  { assert (0 <= a ^ 2) by apply pow2_ge_0; lra. }
  apply Rmult_le_reg_r with (4 * h ^ 2 * d ^ 2); [apply Rmult_lt_0_compat; lra|].
  replace (r ^ 2 * (4 * h ^ 2 * d ^ 2)) with (4 * r ^ 2 * twice_area m n p ^ 2) by (rewrite Area; ring).
  rewrite F, <- D2.
  replace (d ^ 2 * square_distance n p * square_distance p m)
    with (square_distance n p * square_distance p m * d ^ 2) by ring; rewrite Prod.
  replace (((a ^ 2 + h ^ 2) / (2 * h)) ^ 2 * (4 * h ^ 2 * d ^ 2)) with ((a ^ 2 + h ^ 2) ^ 2 * d ^ 2) by (field; lra).
  apply Rmult_le_compat_r; lra.
Qed.
