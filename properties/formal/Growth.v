(* T2 and T2-corner of THEORY.md: the circumradius of one new triangle s = (m, n, p). *)
From Pardel Require Import Plane Pencil Lemma5.

(* T2 at a free edge: t = (m, n, l) contains p in its disk, and t' = (n, m, l') does not. *)
Theorem T2_free_edge : forall m n l l' p ot os ot' rt rs rt',
  triangle m n l -> triangle m n p -> triangle n m l' ->
  circumcircle m n l ot rt -> circumcircle m n p os rs -> circumcircle n m l' ot' rt' ->
  in_disk ot rt p -> ~ in_disk ot' rt' p -> rs <= Rmax rt rt'.
Proof. intros m n l l' p ot os ot' rt rs rt'; intros; now apply (Lemma5b_radius m n l p ot os rt rs) with l' ot'. Qed.

(* T2 at a wall or a border edge, if p is not strictly inside its diametral circle. *)
Theorem T2_wall : forall m n l p ot os rt rs,
  triangle m n l -> triangle m n p -> circumcircle m n l ot rt -> circumcircle m n p os rs ->
  in_disk ot rt p -> ~ in_diametral_circle m n p -> rs < rt.
Proof. intros m n l p ot os rt rs; intros; now apply (Lemma5c_radius m n l p ot os rt rs). Qed.

(* The angle at p between m and n is less than 180 degrees - beta: its cosine is above - cos beta. *)
Definition outside_lens (beta : R) (m n p : point) : Prop :=
  - cos beta * (distance p m * distance p n) < dot_at p m n.

(* |pm| |pn| |mn| = 2 r * twice the area. *)
Lemma product_of_edges : forall m n p o r, triangle m n p -> circumcircle m n p o r ->
  distance p m * distance p n * distance m n = 2 * r * twice_area m n p.
Proof.
  intros m n p o r T C; assert (F := circumradius_formula m n p o r C).
  assert (R := circle_radius_nonnegative m n o r (edge_of_circumcircle m n p o r C)).
  assert (A := distance_nonnegative p m); assert (B := distance_nonnegative p n).
  assert (D := distance_nonnegative m n); unfold triangle in T.
  apply equal_of_squares; [repeat apply Rmult_le_pos; lra|repeat apply Rmult_le_pos; lra|].
  rewrite !Rpow_mult_distr, !distance_squared.
  rewrite (square_distance_symmetric p n).
  replace (2 ^ 2 * r ^ 2 * twice_area m n p ^ 2) with (4 * r ^ 2 * twice_area m n p ^ 2) by ring.
  rewrite F; ring.
Qed.

(* T2 with a lens: beta is 2 alpha, at most 90 degrees. *)
Theorem T2_lens : forall alpha m n l p ot os rt rs,
  0 < alpha -> alpha <= PI / 4 ->
  triangle m n l -> triangle m n p -> circumcircle m n l ot rt -> circumcircle m n p os rs ->
  in_disk ot rt p -> outside_lens (2 * alpha) m n p ->
  rs <= Rmax rt (distance m n / (2 * sin (2 * alpha))).
Proof.
  intros alpha m n l p ot os rt rs A0 A1 T S Ct Cs I O.
  destruct (Rle_or_lt 0 (dot_at p m n)) as [H|H].
  { apply Rle_trans with rt; [|apply Rmax_l]; left; apply (T2_wall m n l p ot os); try assumption.
    rewrite in_diametral_circle_is_obtuse; lra. }
  apply Rle_trans with (2 := Rmax_r _ _).
  assert (Sin : 0 < sin (2 * alpha)) by (apply sin_gt_0; lra).
  assert (Cos : 0 <= cos (2 * alpha)) by (apply cos_ge_0; lra).
  assert (One := sin2_cos2 (2 * alpha)); unfold Rsqr in One.
  assert (P := product_of_edges m n p os rs S Cs).
  assert (Lg := lagrange m n p); rewrite <- !distance_squared in Lg.
  unfold outside_lens, triangle in *.
  assert (B := distance_nonnegative p m); assert (C := distance_nonnegative p n).
  assert (D := edge_positive m n l T).
  set (N := distance p m * distance p n) in *; set (k := twice_area m n p) in *; set (c := dot_at p m n) in *.
  set (s := sin (2 * alpha)) in *; set (g := cos (2 * alpha)) in *.
  assert (N0 : 0 <= N) by now apply Rmult_le_pos.
  assert (L : N ^ 2 = c ^ 2 + k ^ 2) by (rewrite <- Lg; unfold N; ring).
  assert (Q : (- c) ^ 2 <= (g * N) ^ 2) by (apply pow_incr; lra).
  assert (Sk : s * N <= k).
  { apply at_most_of_squares; [lra|].
    replace ((s * N) ^ 2) with (N ^ 2 - (g * N) ^ 2) by (replace ((s * N) ^ 2) with (s * s * N ^ 2) by ring;
      replace (s * s) with (1 - g * g) by lra; ring).
    replace ((- c) ^ 2) with (c ^ 2) in Q by ring; lra. }
  apply Rmult_le_reg_r with (2 * s * k); [repeat apply Rmult_lt_0_compat; lra|].
  replace (distance m n / (2 * s) * (2 * s * k)) with (distance m n * k) by (field; lra).
  replace (rs * (2 * s * k)) with (s * N * distance m n)
    by (replace (rs * (2 * s * k)) with (s * (2 * rs * k)) by ring; rewrite <- P; ring).
  rewrite (Rmult_comm (distance m n)); apply Rmult_le_compat_r; lra.
Qed.

(* T2 with a lens: while a wall is no longer than 2 r, a new circumradius is at most r / sin 2 alpha. *)
Corollary T2_lens_factor : forall alpha r m n l p ot os rt rs,
  0 < alpha -> alpha <= PI / 4 ->
  triangle m n l -> triangle m n p -> circumcircle m n l ot rt -> circumcircle m n p os rs ->
  in_disk ot rt p -> outside_lens (2 * alpha) m n p ->
  distance m n <= 2 * r -> rt <= r / sin (2 * alpha) -> rs <= r / sin (2 * alpha).
Proof.
  intros alpha r m n l p ot os rt rs A0 A1 T S Ct Cs I O M Rt.
  assert (Sin : 0 < sin (2 * alpha)) by (apply sin_gt_0; lra).
  apply Rle_trans with (1 := T2_lens alpha m n l p ot os rt rs A0 A1 T S Ct Cs I O).
  apply Rmax_lub; [assumption|].
  apply Rmult_le_reg_r with (2 * sin (2 * alpha)); [lra|].
  replace (distance m n / (2 * sin (2 * alpha)) * (2 * sin (2 * alpha))) with (distance m n) by (field; lra).
  replace (r / sin (2 * alpha) * (2 * sin (2 * alpha))) with (2 * r) by (field; lra).
  assumption.
Qed.

(* T2, "the theorem fails when p encroaches": the example of THEORY.md. *)
Example T2_fails_for_an_encroaching_point :
  let m : point := (-1, 0) in let n : point := (1, 0) in
  let l : point := (0, 2) in let p : point := (0, 1 / 8) in
  triangle m n l /\ triangle m n p /\ in_diametral_circle m n p /\
  exists ot os, circumcircle m n l ot (5 / 4) /\ in_disk ot (5 / 4) p /\ circumcircle m n p os (65 / 16).
Proof.
  cbv zeta; split; [unfold triangle, twice_area; cbn [fst snd]; lra|].
  split; [unfold triangle, twice_area; cbn [fst snd]; lra|].
  split; [rewrite in_diametral_circle_is_obtuse; unfold dot_at; cbn [fst snd]; lra|].
  exists ((0, 3 / 4) : point), ((0, - 63 / 16) : point).
  assert (E : forall o q r, 0 <= r -> square_distance o q = r ^ 2 -> distance o q = r)
    by (intros o q r R H; unfold distance; rewrite H; now apply sqrt_pow2).
  repeat split; try (apply E; [lra|unfold square_distance; cbn [fst snd]; field]).
  apply in_disk_is_negative_power; [lra|]; unfold power, square_distance; cbn [fst snd]; lra.
Qed.

(* The cosine of the angle at a between b and x, for T2-corner. *)
Definition cosine (a b x : point) : R := dot_at a b x / (distance a b * distance a x).

(* The factor of T2-corner, with theta the angle between the walls. *)
Definition corner_factor (lambda theta : R) : R := sqrt (1 + (1 - lambda) ^ 2 * (cos theta / sin theta) ^ 2).

(* The point that splits ab. *)
Definition split_point (lambda : R) (a b : point) : point :=
  (a.x + lambda * (b.x - a.x), a.y + lambda * (b.y - a.y)).

Lemma corner_factor_at_least_one : forall lambda theta, 1 <= corner_factor lambda theta.
Proof.
  intros; unfold corner_factor; rewrite <- sqrt_1 at 1; apply sqrt_le_1_alt.
  assert (0 <= ((1 - lambda) * (cos theta / sin theta)) ^ 2) by apply pow2_ge_0.
  rewrite Rpow_mult_distr in *; lra.
Qed.

(* T2-corner. The walls are ab and ax, p splits ab, b does not encroach upon ax, and p lies in the disk of the triangle
   t = (a, x, l) on the side of b. *)
Theorem T2_corner : forall lambda theta a b x l p ot os rt rs,
  0 < lambda < 1 -> 0 < theta < PI / 2 -> cos theta = cosine a b x ->
  p = split_point lambda a b ->
  triangle a x l -> triangle a x b -> circumcircle a x l ot rt -> circumcircle a x p os rs ->
  in_disk ot rt p -> 0 < dot_at b a x ->
  rs <= corner_factor lambda theta * rt.
Proof.
  intros lambda theta a b x l p ot os rt rs L Th Cos P T B Ct Cs I Enc.
  assert (One := corner_factor_at_least_one lambda theta).
  assert (Nt := circle_radius_nonnegative a x ot rt (edge_of_circumcircle a x l ot rt Ct)).
  assert (Ns := circle_radius_nonnegative a x os rs (edge_of_circumcircle a x p os rs Cs)).
  assert (Tp : triangle a x p).
  { unfold triangle in *; rewrite P.
    replace (twice_area a x (split_point lambda a b)) with (lambda * twice_area a x b)
      by (unfold twice_area, split_point; cbn [fst snd]; ring).
    apply Rmult_lt_0_compat; lra. }
  destruct (Rle_or_lt 0 (dot_at p a x)) as [H|H].
  { assert (rs < rt)
      by (apply (T2_wall a x l p ot os rt rs); try assumption; rewrite in_diametral_circle_is_obtuse; lra).
    assert (1 * rt <= corner_factor lambda theta * rt) by (apply Rmult_le_compat_r; lra). lra. }
  assert (D := edge_positive a x b B).
  assert (Chord := radius_in_the_pencil a x ot rt (edge_of_circumcircle a x l ot rt Ct) D).
  assert (Hh := pow2_ge_0 (height a x ot)).
  assert (F := circumradius_formula a x p os rs Cs).
  assert (Lg := lagrange b x a).
  unfold triangle in B.
  assert (B' : 0 < distance a b)
    by (rewrite distance_symmetric; apply (edge_positive b a x); unfold triangle, twice_area in *; lra).
  assert (DD := distance_squared a b); assert (VV := distance_squared a x).
  rewrite (square_distance_symmetric a b) in DD.
  set (V := square_distance a x) in *; set (E := square_distance b a) in *.
  set (c := dot_at a b x) in *; set (k := twice_area a x b) in *.
  assert (Lg' : E * V = c ^ 2 + k ^ 2)
    by (unfold E, V, c, k, square_distance, dot_at, twice_area; ring).
  assert (E0 : 0 < E) by (rewrite <- DD; now apply pow_lt).
  assert (V0 : 0 < V) by (rewrite <- VV; now apply pow_lt).
  assert (Db : dot_at b a x = E - c) by (unfold E, c, square_distance, dot_at; ring).
  assert (Dp : dot_at p a x = lambda * (lambda * E - c))
    by (rewrite P; unfold E, c, square_distance, dot_at, split_point; cbn [fst snd]; ring).
  assert (Kp : twice_area a x p = lambda * k)
    by (rewrite P; unfold k, twice_area, split_point; cbn [fst snd]; ring).
  assert (Sxp : square_distance x p = V - 2 * lambda * c + lambda ^ 2 * E)
    by (rewrite P; unfold V, E, c, square_distance, dot_at, split_point; cbn [fst snd]; ring).
  assert (Spa : square_distance p a = lambda ^ 2 * E)
    by (rewrite P; unfold E, square_distance, split_point; cbn [fst snd]; ring).
  rewrite Kp, Sxp, Spa in F; rewrite Db in Enc; rewrite Dp in H.
  assert (Pe : lambda * E < c) by (apply Rmult_lt_reg_l with lambda; lra).
  assert (C0 : 0 < c) by (assert (0 < lambda * E) by (apply Rmult_lt_0_compat; lra); lra).
  (* f^2 in terms of c and k *)
  assert (Sin : 0 < sin theta) by (apply sin_gt_0; lra).
  assert (SC := sin2_cos2 theta); unfold Rsqr in SC.
  assert (Cot : (cos theta / sin theta) ^ 2 = c ^ 2 / k ^ 2).
  { assert (C2 : cos theta ^ 2 = c ^ 2 / (E * V)).
    { rewrite Cos; unfold cosine; fold c; rewrite <- DD, <- VV; field; lra. }
    assert (S2 : sin theta ^ 2 = k ^ 2 / (E * V)).
    { replace (sin theta ^ 2) with (1 - cos theta ^ 2) by lra; rewrite C2.
      replace (k ^ 2) with (E * V - c ^ 2) by lra; field; lra. }
    unfold Rdiv; rewrite Rpow_mult_distr, pow_inv, C2, S2; field; repeat split; lra. }
  assert (F2 : corner_factor lambda theta ^ 2 = 1 + (1 - lambda) ^ 2 * (c ^ 2 / k ^ 2)).
  { unfold corner_factor; rewrite pow2_sqrt, Cot; [reflexivity|].
    rewrite Cot; assert (0 <= ((1 - lambda) * (c / k)) ^ 2) by apply pow2_ge_0.
    unfold Rdiv in *; rewrite !Rpow_mult_distr, pow_inv in *; lra. }
  (* the heart: |px|^2 |ab|^2 <= k^2 + (1 - lambda)^2 c^2 *)
  assert (Heart : (V - 2 * lambda * c + lambda ^ 2 * E) * E <= k ^ 2 + (1 - lambda) ^ 2 * c ^ 2).
  { assert (0 <= lambda * (E - c) * (2 * c - lambda * (E + c))).
    { apply Rmult_le_pos; [apply Rmult_le_pos; lra|].
      assert (lambda * c <= 1 * c) by (apply Rmult_le_compat_r; lra). lra. }
    replace (k ^ 2) with (E * V - c ^ 2) by lra. lra. }
  apply at_most_of_squares; [apply Rmult_le_pos; lra|].
  rewrite Rpow_mult_distr, F2.
  assert (K2 : 0 < k ^ 2) by (apply pow_lt; lra); assert (L2 : 0 < lambda ^ 2) by (apply pow_lt; lra).
  rewrite VV in Chord.
  apply Rle_trans with ((1 + (1 - lambda) ^ 2 * (c ^ 2 / k ^ 2)) * (V / 4)).
  - apply Rmult_le_reg_r with (4 * (lambda ^ 2 * k ^ 2)); [repeat apply Rmult_lt_0_compat; lra|].
    replace (rs ^ 2 * (4 * (lambda ^ 2 * k ^ 2))) with (4 * rs ^ 2 * (lambda * k) ^ 2) by ring.
    rewrite F.
    replace ((1 + (1 - lambda) ^ 2 * (c ^ 2 / k ^ 2)) * (V / 4) * (4 * (lambda ^ 2 * k ^ 2)))
      with (V * lambda ^ 2 * (k ^ 2 + (1 - lambda) ^ 2 * c ^ 2)) by (field; lra).
    replace (V * (V - 2 * lambda * c + lambda ^ 2 * E) * (lambda ^ 2 * E))
      with (V * lambda ^ 2 * ((V - 2 * lambda * c + lambda ^ 2 * E) * E)) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|exact Heart].
  - apply Rmult_le_compat_l; [|lra].
    rewrite <- F2; apply pow2_ge_0.
Qed.

(* T2-corner, for the midpoint: f^2 = (4 / c^2 - 3) / (4 / c^2 - 4) with c = cos theta. *)
Theorem T2_corner_midpoint : forall theta, 0 < theta < PI / 2 ->
  corner_factor (1 / 2) theta ^ 2 = (4 / cos theta ^ 2 - 3) / (4 / cos theta ^ 2 - 4).
Proof.
  intros theta T; unfold corner_factor.
  assert (C : 0 < cos theta) by (apply cos_gt_0; lra); assert (S : 0 < sin theta) by (apply sin_gt_0; lra).
  assert (One := sin2_cos2 theta); unfold Rsqr in One.
  rewrite pow2_sqrt.
  - set (s := sin theta) in *; set (c := cos theta) in *.
    assert (E : 1 - c ^ 2 = s ^ 2) by lra.
    assert (0 < s ^ 2) by now apply pow_lt.
    replace (4 / c ^ 2 - 4) with (4 * s ^ 2 / c ^ 2) by (rewrite <- E; field; lra).
    replace (4 / c ^ 2 - 3) with ((4 * s ^ 2 + c ^ 2) / c ^ 2) by (rewrite <- E; field; lra).
    field; lra.
  - assert (0 <= ((1 - 1 / 2) * (cos theta / sin theta)) ^ 2) by apply pow2_ge_0.
    rewrite Rpow_mult_distr in *; lra.
Qed.
