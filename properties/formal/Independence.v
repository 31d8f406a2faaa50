(* Lemma 6 for cavities, and the distance parts of T1 and T1-sharp of THEORY.md. *)
From Coq Require Import List.
From Pardel Require Import Plane Pencil Lemma5.

(* A triangle of a mesh with its circumcircle. *)
Record element : Type := Element { first : point; second : point; third : point; centre : point; radius : R }.

Definition proper (t : element) : Prop :=
  triangle (first t) (second t) (third t) /\
  circumcircle (first t) (second t) (third t) (centre t) (radius t).
Definition has_vertex (t : element) (v : point) : Prop := v = first t \/ v = second t \/ v = third t.
(* mn is an edge of t, and t lies on the left of it. *)
Definition has_edge (t : element) (m n : point) : Prop :=
  (m, n) = (first t, second t) \/ (m, n) = (second t, third t) \/ (m, n) = (third t, first t).

Section Mesh.
  Variable mesh : list element.
  (* Which triangles a point sees, and which edges are free. The theorems hold for every such relation. *)
  Variable sees : point -> element -> Prop.
  Variable free : point -> point -> Prop.
  Hypothesis all_proper : forall t, In t mesh -> proper t.

  Definition in_cavity (p : point) (t : element) : Prop :=
    In t mesh /\ in_disk (centre t) (radius t) p /\ sees p t.

  (* R bounds the circumradii of the cavity of p. R(p) of THEORY.md is the least such number. *)
  Definition bounds_cavity (R : R) (p : point) : Prop := forall t, in_cavity p t -> radius t <= R.

  Lemma vertex_on_circle : forall t v, proper t -> has_vertex t v -> on_circle (centre t) (radius t) v.
  Proof. intros t v (_ & A & B & C) [->|[->| ->]]; assumption. Qed.

  (* Lemma 6 (reach). *)
  Theorem Lemma6_reach_of_a_cavity : forall p t v R, bounds_cavity R p -> in_cavity p t -> has_vertex t v ->
    distance p v < 2 * R.
  Proof.
    intros p t v R B T V; assert (H := B t T); destruct T as (M & D & _).
    assert (L := Lemma6_reach _ _ v p (vertex_on_circle t v (all_proper t M) V) D); lra.
  Qed.

  (* T1: at the distance 2 R(p) + 2 R(q) the closures of the cavities have no common vertex. *)
  Theorem T1_no_common_vertex : forall p q Rp Rq, bounds_cavity Rp p -> bounds_cavity Rq q ->
    2 * Rp + 2 * Rq <= distance p q ->
    forall t t' v, in_cavity p t -> in_cavity q t' -> has_vertex t v -> ~ has_vertex t' v.
  Proof.
    intros p q Rp Rq Bp Bq F t t' v T T' V V'.
    assert (A := Lemma6_reach_of_a_cavity p t v Rp Bp T V).
    assert (B := Lemma6_reach_of_a_cavity q t' v Rq Bq T' V').
    assert (C := distance_triangle_inequality p v q); rewrite (distance_symmetric v q) in C; lra.
  Qed.

  Theorem T1_at_four_circumradii : forall p q r, (forall t, In t mesh -> radius t <= r) -> 4 * r <= distance p q ->
    forall t t' v, in_cavity p t -> in_cavity q t' -> has_vertex t v -> ~ has_vertex t' v.
  Proof.
    intros p q r B F; apply (T1_no_common_vertex p q r r); [| |lra]; intros t (M & _); now apply B.
  Qed.

  (* T1: the rings are disjoint, too. A triangle with two vertices of one cavity does not have two of the other. *)
  Definition has_two_vertices_of_cavity (p : point) (t : element) : Prop :=
    exists u v, u <> v /\ has_vertex t u /\ has_vertex t v /\
      (exists s, in_cavity p s /\ has_vertex s u) /\ (exists s, in_cavity p s /\ has_vertex s v).

  Theorem T1_no_common_triangle_rings_included : forall p q Rp Rq, bounds_cavity Rp p -> bounds_cavity Rq q ->
    2 * Rp + 2 * Rq <= distance p q ->
    forall t, has_two_vertices_of_cavity p t -> ~ has_two_vertices_of_cavity q t.
  Proof.
    intros p q Rp Rq Bp Bq F t (u & v & Duv & Tu & Tv & (s & S & Su) & (s' & S' & Sv))
      (u' & v' & Duv' & Tu' & Tv' & (w & W & Wu) & (w' & W' & Wv)).
    assert (N : forall a b x, in_cavity p a -> in_cavity q b -> has_vertex a x -> ~ has_vertex b x)
      by (apply (T1_no_common_vertex p q Rp Rq); assumption).
    assert (u <> u') by (intros ->; now apply (N s w u')).
    assert (u <> v') by (intros ->; now apply (N s w' v')).
    assert (v <> u') by (intros ->; now apply (N s' w u')).
    assert (v <> v') by (intros ->; now apply (N s' w' v')).
    clear - Duv Duv' H H0 H1 H2 Tu Tv Tu' Tv'; unfold has_vertex in *.
    destruct Tu as [A|[A|A]], Tv as [B|[B|B]]; try congruence;
      destruct Tu' as [C|[C|C]]; try congruence; destruct Tv' as [E|[E|E]]; congruence.
  Qed.

  (* The condition of T1-iff: no triangle belongs to both cavities, and no free edge mn on both boundaries has q in the
     disk of (m, n, p). By T1-iff it says that p and q are independent. Here mn is directed so that its triangle t in the
     cavity of p lies on the left; the triangle t' of the cavity of q lies on the right. *)
  Definition common_triangle (p q : point) : Prop := exists t, in_cavity p t /\ in_cavity q t.
  Definition common_edge (p q m n : point) (t t' : element) : Prop :=
    free m n /\ in_cavity p t /\ has_edge t m n /\ ~ in_cavity p t' /\
    in_cavity q t' /\ has_edge t' n m /\ ~ in_cavity q t.
  Definition condition_of_T1_iff (p q : point) : Prop :=
    ~ common_triangle p q /\
    forall m n t t' o r, common_edge p q m n t t' -> circumcircle m n p o r -> ~ in_disk o r q.

  (* Lemma 4, (a) and the first paragraph: p is on the left of each edge of the boundary of its cavity that does not
     contain p, and it lies in no disk beyond a free one. *)
  Definition lemma4 (p : point) : Prop :=
    forall m n t t', free m n -> in_cavity p t -> has_edge t m n -> In t' mesh -> has_edge t' n m -> ~ in_cavity p t' ->
    triangle m n p /\ ~ in_disk (centre t') (radius t') p.

  (* Which edge of t comes first does not matter. *)
  Lemma edge_with_apex : forall t m n, proper t -> has_edge t m n ->
    exists l, triangle m n l /\ circumcircle m n l (centre t) (radius t).
  Proof.
    intros t m n (T & A & B & C) E; unfold triangle in *.
    assert (T1 := T); rewrite <- twice_area_turned in T1; assert (T2 := T1); rewrite <- twice_area_turned in T2.
    destruct E as [E|[E|E]]; injection E as -> ->;
      [exists (third t)|exists (first t)|exists (second t)]; split; try assumption; repeat split; assumption.
  Qed.

  (* T1-sharp, first step: a common triangle t. *)
  Theorem T1_sharp_common_triangle : forall p q t, in_cavity p t -> in_cavity q t -> distance p q < 2 * radius t.
  Proof. intros p q t (_ & P & _) (_ & Q & _); exact (two_points_in_one_disk _ _ p q P Q). Qed.

  (* T1-sharp, second step: a common free edge mn with q in the disk of (m, n, p). *)
  Theorem T1_sharp_common_edge : forall p q Rp Rq m n t t' o r,
    lemma4 p -> bounds_cavity Rp p -> bounds_cavity Rq q ->
    common_edge p q m n t t' -> circumcircle m n p o r -> in_disk o r q -> distance p q < 2 * Rmax Rp Rq.
  Proof.
    intros p q Rp Rq m n t t' o r L Bp Bq (F & P & E & P' & Q & E' & Q') C I.
    assert (T : proper t) by (apply all_proper, P); assert (T' : proper t') by (apply all_proper, Q).
    destruct (L m n t t' F P E (proj1 Q) E' P') as [S N].
    destruct (edge_with_apex t m n T E) as (l & Tl & Cl).
    destruct (edge_with_apex t' n m T' E') as (l' & Tl' & Cl').
    assert (H : r <= Rmax (radius t) (radius t'))
      by (apply (Lemma5b_radius m n l p (centre t) o (radius t) r) with l' (centre t'); try assumption; apply P).
    assert (A := Bp t P); assert (B := Bq t' Q).
    assert (D := Lemma6_reach o r p q (proj2 (proj2 C)) I); rewrite distance_symmetric in D.
    assert (Rmax (radius t) (radius t') <= Rmax Rp Rq).
    { apply Rmax_lub; [apply Rle_trans with (1 := A), Rmax_l|apply Rle_trans with (1 := B), Rmax_r]. }
    lra.
  Qed.

  (* T1-sharp: at the distance 2 max(R(p), R(q)) the condition of T1-iff holds. *)
  Theorem T1_sharp : forall p q Rp Rq, lemma4 p -> bounds_cavity Rp p -> bounds_cavity Rq q ->
    2 * Rmax Rp Rq <= distance p q -> condition_of_T1_iff p q.
  Proof.
    intros p q Rp Rq L Bp Bq F; split.
    - intros (t & P & Q); assert (H := T1_sharp_common_triangle p q t P Q); assert (A := Bp t P).
      assert (B := Rmax_l Rp Rq); lra.
    - intros m n t t' o r E C I; assert (H := T1_sharp_common_edge p q Rp Rq m n t t' o r L Bp Bq E C I); lra.
  Qed.

  Theorem T1_sharp_at_two_circumradii : forall p q r, lemma4 p -> (forall t, In t mesh -> radius t <= r) ->
    2 * r <= distance p q -> condition_of_T1_iff p q.
  Proof.
    intros p q r L B F; apply (T1_sharp p q r r L); [| |rewrite Rmax_left; lra]; intros t (M & _); now apply B.
  Qed.
End Mesh.
