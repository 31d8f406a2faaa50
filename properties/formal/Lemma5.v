(* Lemma 5 (pencil) of THEORY.md. *)
From Pardel Require Import Plane Pencil.

(* Lemma 5 (pencil). t = (m, n, l) is the triangle of the cavity at the edge mn, s = (m, n, p) is the new triangle, and p
   lies in the disk of t. *)
Section Lemma5.
  Variables m n l p ot os : point.
  Variables rt rs : R.
  Hypothesis t : triangle m n l.
  Hypothesis s : triangle m n p.
  Hypothesis circle_of_t : circumcircle m n l ot rt.
  Hypothesis circle_of_s : circumcircle m n p os rs.
  Hypothesis p_in_disk_of_t : in_disk ot rt p.

  Let D : 0 < distance m n := edge_positive m n l t.
  Let Ct : circle_through m n ot rt := edge_of_circumcircle m n l ot rt circle_of_t.
  Let Cs : circle_through m n os rs := edge_of_circumcircle m n p os rs circle_of_s.

  Theorem Lemma5a_heights : height m n os < height m n ot.
  Proof.
    assert (H := height_on_the_left _ _ _ s).
    assert (Z : power os rs p = 0) by (apply power_on_circle, circle_of_s).
    assert (N : power ot rt p < 0)
      by (apply in_disk_is_negative_power; [now apply (circle_radius_nonnegative m n ot)|assumption]).
    rewrite (power_in_the_pencil m n os rs p Cs D) in Z; rewrite (power_in_the_pencil m n ot rt p Ct D) in N.
    apply Rmult_lt_reg_r with (height m n p); [assumption|lra].
  Qed.

  Theorem Lemma5a_disks : forall x, 0 <= height m n x -> in_disk os rs x -> in_disk ot rt x.
  Proof.
    intros x X I; assert (H := Lemma5a_heights).
    apply in_disk_is_negative_power in I; [|now apply (circle_radius_nonnegative m n os)].
    apply in_disk_is_negative_power; [now apply (circle_radius_nonnegative m n ot)|].
    rewrite (power_in_the_pencil m n os rs x Cs D) in I; rewrite (power_in_the_pencil m n ot rt x Ct D).
    assert (0 <= (height m n ot - height m n os) * height m n x) by (apply Rmult_le_pos; lra).
    lra.
  Qed.

  (* Part (b): t' = (n, m, l') is the triangle beyond mn, and p does not lie in its disk. *)
  Section FreeEdge.
    Variables l' ot' : point.
    Variable rt' : R.
    Hypothesis t' : triangle n m l'.
    Hypothesis circle_of_t' : circumcircle n m l' ot' rt'.
    Hypothesis p_not_in_disk_of_t' : ~ in_disk ot' rt' p.

    Let Ct' : circle_through m n ot' rt' := reversed_edge_of_circumcircle m n l' ot' rt' circle_of_t'.

    Theorem Lemma5b_heights : height m n ot' <= height m n os.
    Proof.
      assert (H := height_on_the_left _ _ _ s).
      assert (Z : power os rs p = 0) by (apply power_on_circle, circle_of_s).
      assert (R := circle_radius_nonnegative m n ot' rt' Ct').
      assert (N : 0 <= power ot' rt' p).
      { apply Rnot_lt_le; intro N; apply p_not_in_disk_of_t'; now apply in_disk_is_negative_power. }
      rewrite (power_in_the_pencil m n os rs p Cs D) in Z; rewrite (power_in_the_pencil m n ot' rt' p Ct' D) in N.
      apply Rmult_le_reg_r with (height m n p); [assumption|lra].
    Qed.

    Theorem Lemma5b_disks : forall x, height m n x <= 0 -> in_disk os rs x -> in_disk ot' rt' x.
    Proof.
      intros x X I; assert (H := Lemma5b_heights).
      apply in_disk_is_negative_power in I; [|now apply (circle_radius_nonnegative m n os)].
      apply in_disk_is_negative_power; [now apply (circle_radius_nonnegative m n ot')|].
      rewrite (power_in_the_pencil m n os rs x Cs D) in I; rewrite (power_in_the_pencil m n ot' rt' x Ct' D).
      assert (0 <= (height m n os - height m n ot') * - height m n x) by (apply Rmult_le_pos; lra).
      lra.
    Qed.

    Theorem Lemma5b_radius : rs <= Rmax rt rt'.
    Proof.
      assert (A := Lemma5a_heights); assert (B := Lemma5b_heights).
      assert (Rt := radius_in_the_pencil m n ot rt Ct D); assert (Rs := radius_in_the_pencil m n os rs Cs D).
      assert (Rt' := radius_in_the_pencil m n ot' rt' Ct' D).
      assert (Nt := circle_radius_nonnegative m n ot rt Ct); assert (Nt' := circle_radius_nonnegative m n ot' rt' Ct').
      destruct (Rle_or_lt 0 (height m n os)).
      - apply Rle_trans with rt; [|apply Rmax_l]; apply at_most_of_squares; [assumption|nra].
      - apply Rle_trans with rt'; [|apply Rmax_r]; apply at_most_of_squares; [assumption|nra].
    Qed.
  End FreeEdge.

  (* Part (c). *)
  Hypothesis p_not_in_diametral_circle : ~ in_diametral_circle m n p.

  Theorem Lemma5c_heights : 0 <= height m n os < height m n ot.
  Proof.
    split; [|exact Lemma5a_heights].
    assert (H := height_on_the_left _ _ _ s).
    assert (Z : power os rs p = 0) by (apply power_on_circle, circle_of_s).
    rewrite in_diametral_circle_is_obtuse in p_not_in_diametral_circle.
    rewrite (power_in_the_pencil m n os rs p Cs D) in Z.
    apply Rmult_le_reg_r with (height m n p); [assumption|lra].
  Qed.

  Theorem Lemma5c_radius : rs < rt.
  Proof.
    assert (A := Lemma5c_heights).
    assert (Rt := radius_in_the_pencil m n ot rt Ct D); assert (Rs := radius_in_the_pencil m n os rs Cs D).
    assert (Nt := circle_radius_nonnegative m n ot rt Ct).
    apply below_of_squares; [assumption|nra].
  Qed.
End Lemma5.
