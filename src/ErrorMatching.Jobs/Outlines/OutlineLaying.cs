using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>Where a drawing's outline lies on what a program cuts.</summary>
/// <param name="Frame">From the drawing to the program.</param>
/// <param name="RadiusMm">Radius of the tool: the distance of the outline from the path where the control does not offset it.</param>
/// <param name="CoveredShare">The share of the outline's length that the program cuts.</param>
/// <param name="RmsMm">Root mean square of what is left over along that share.</param>
/// <param name="LargestMm">The largest of it.</param>
/// <param name="Others">How many other ways to lay it cover as much.</param>
internal sealed record OutlineLaying(
    RigidTransform2 Frame, double RadiusMm, double CoveredShare, double RmsMm, double LargestMm, int Others)
{
    /// <summary>Farther from where the tool's radius puts it, a place of the outline is not cut by the program, mm.</summary>
    public const double CoverMm = 0.2;

    // A laying that covers less of the outline is none, unless the program follows the outline nearly all of its way: a part may have other
    // edges, too, which another program cuts.
    private const double LeastShare = 0.5;
    private const double LeastOfPart = 0.2;
    private const double LeastOfCut = 0.6;

    // The outline is sampled at this distance, and by no more places.
    private const double SampleMm = 1;
    private const int MostSamples = 400;
    private const int FewSamples = 48;
    private const int LeastOfFew = 20;
    private const int LeastOfPlaces = 9;
    private const double RoughMm = 0.5;

    // Candidates that cover the most of few places are refined with all.
    private const int Refined = 12;
    private const int Rounds = 25;

    // Cosines of the angles between two lines that tell a place: 20 to 160 degrees.
    private const double ParallelCosine = 0.94;

    // Angles that differ by less are the same, radians: a third of a degree.
    private const double SameAngle = 0.006;

    // Cosine of 12 degrees: what cuts a place leads along it.
    private const double ParallelCross = 0.978;

    // In the next round, places count that are off by no more than this many times what four of five are off by. Of the middle one, half
    // of an outline could fit exactly and keep the other half out. Not less than half of the distance before: a step may move them.
    private const double LeastCaptureMm = 0.005;
    private const double OfMost = 2.5;
    private const double Most = 0.8;

    // Two ways that differ by less are one.
    private const double SameWayMm = 0.05;

    // Radii that tools have, mm, where nobody says which one it is.
    private static readonly double[] _radii = [0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12.5];

    /// <summary>Lays an outline on a program's cuts.</summary>
    /// <param name="elements">The outline's elements.</param>
    /// <param name="cuts">What the program cuts.</param>
    /// <param name="radiusMm">Radius of the tool; null to find it.</param>
    /// <returns>The way that covers the most, and of equal ones the one that moves the drawing least: without mirror, then by the least
    /// rotation, then by the least shift. Null if none covers enough of the outline, or of the program's way.</returns>
    public static OutlineLaying? Find(IReadOnlyList<OutlineElement> elements, CutPath cuts, double? radiusMm)
    {
        var samples = Samples(elements);
        double[] radii = radiusMm is { } given ? [given] : cuts.IsCompensated == true ? [0] : _radii;
        var found = new List<OutlineLaying>();
        foreach (var mirror in new[] { Mirror.None, Mirror.X })
        {
            found.AddRange(Best(elements, samples, cuts, mirror, radii));
        }

        OutlineLaying[] ordered = [
            .. found.OrderByDescending(f => Math.Round(f.CoveredShare, 2)).ThenBy(f => Math.Round(f.RmsMm, 3))
                .ThenBy(f => f.Frame.Mirror != Mirror.None).ThenBy(f => Math.Round(Math.Abs(f.Frame.Rotation.Degrees), 3))
                .ThenBy(f => f.Frame.Translation.Length)];
        if (ordered is not [var best, ..] || !IsEnough(best.CoveredShare, elements.Sum(e => e.LengthMm), cuts.LengthMm))
        {
            return null;
        }

        var others = ordered.Skip(1).Where(
            o => o.CoveredShare > best.CoveredShare - 0.01 && o.RmsMm < best.RmsMm + 0.01 && !IsSame(o.Frame, best.Frame, samples));
        return best with { Others = others.Count() };
    }

    private static bool IsEnough(double share, double outlineMm, double cutMm) =>
        share >= LeastShare || (share >= LeastOfPart && share * outlineMm >= LeastOfCut * cutMm);

    /// <summary>How far a place of the outline is from where the program's tool leaves it; null if it is not cut, or only
    /// crossed.</summary>
    public double? LeftOver(OutlinePlace drawn, CutPath cuts) => LeftOver(Frame, drawn, cuts, RadiusMm, CoverMm, out _);

    private static double? LeftOver(
        RigidTransform2 frame, OutlinePlace drawn, CutPath cuts, double radius, double withinMm, out CutFoot foot)
    {
        foot = default;
        if (cuts.FootOf(frame.Apply(drawn.At), radius + withinMm) is not { } found)
        {
            return null;
        }

        foot = found;
        var off = found.DistanceMm - (found.IsCompensated ? 0 : radius);
        return Math.Abs(off) <= withinMm && Math.Abs(frame.Apply(drawn.Along).Cross(found.Left)) > ParallelCross ? off : null;
    }

    private static List<OutlinePlace> Samples(IReadOnlyList<OutlineElement> elements)
    {
        var length = elements.Sum(e => e.LengthMm);
        var step = Math.Max(SampleMm, length / MostSamples);
        var samples = new List<OutlinePlace>();
        foreach (var element in elements)
        {
            var n = Math.Max(1, (int)Math.Round(element.LengthMm / step));
            samples.AddRange(Enumerable.Range(0, n).Select(k => element.PlaceAt(element.LengthMm * (k + 0.5) / n)));
        }

        return samples;
    }

    private static IEnumerable<OutlineLaying> Best(
        IReadOnlyList<OutlineElement> elements, List<OutlinePlace> samples, CutPath cuts, Mirror mirror, double[] radii)
    {
        OutlinePlace[] few = [.. Enumerable.Range(0, FewSamples).Select(k => samples[(int)((long)k * samples.Count / FewSamples)])];
        // Where the outline is longer than all cuts, fewer of its places can be cut.
        var least = Math.Clamp((int)(LeastOfFew * cuts.LengthMm / elements.Sum(e => e.LengthMm)), LeastOfPlaces, LeastOfFew);
        var candidates = radii.SelectMany(r => Candidates(elements, cuts, mirror, r, least < LeastOfFew).Select(f => (Frame: f, Radius: r)))
            .Select(c => (c.Frame, c.Radius, Count: Count(c.Frame, few, cuts, c.Radius, least)))
            .Where(c => c.Count >= least)
            .OrderByDescending(c => c.Count).ThenBy(c => Math.Abs(c.Frame.Rotation.Degrees)).ThenBy(c => c.Frame.Translation.Length);
        var taken = new List<RigidTransform2>();
        foreach (var (frame, radius, _) in candidates)
        {
            if (taken.Exists(t => IsSame(t, frame, samples)))
            {
                continue;
            }

            taken.Add(frame);
            yield return Refine(frame, samples, cuts, radius, isGiven: radii.Length == 1);
            if (taken.Count == Refined)
            {
                yield break;
            }
        }
    }

    private static int Count(RigidTransform2 frame, OutlinePlace[] samples, CutPath cuts, double radius, int least)
    {
        var count = 0;
        for (var k = 0; k < samples.Length && count + samples.Length - k >= least; k++)
        {
            count += LeftOver(frame, samples[k], cuts, radius, RoughMm, out _) is null ? 0 : 1;
        }

        return count;
    }

    private static bool IsSame(RigidTransform2 one, RigidTransform2 other, List<OutlinePlace> samples) =>
        samples[0].At is var p && samples[samples.Count / 2].At is var q
            && one.Apply(p).DistanceTo(other.Apply(p)) < SameWayMm && one.Apply(q).DistanceTo(other.Apply(q)) < SameWayMm;

    // As drawn; by two lines that are not parallel; by a line and an arc; by two arcs, or one. Of an outline with edges that the program
    // does not cut, more lines are tried: the longest may be among those.
    private static IEnumerable<RigidTransform2> Candidates(
        IReadOnlyList<OutlineElement> elements, CutPath cuts, Mirror mirror, double radius, bool hasOtherEdges)
    {
        yield return new(mirror, default, Vector2.Zero);
        var turned = new RigidTransform2(mirror, default, Vector2.Zero);
        var lines = elements.Where(e => e.Kind == OutlineElementKind.Line).OrderByDescending(e => e.LengthMm).Take(hasOtherEdges ? 12 : 6)
            .Select(e => (At: turned.Apply(e.From), Along: turned.Apply((e.To - e.From).Normalize()))).ToArray();
        var arcs = elements.SelectMany(e => e.Curves).OfType<DrawnArc>().OrderByDescending(a => a.LengthMm).Take(4)
            .Select(a => (Center: turned.Apply(a.Center), a.Radius)).ToArray();
        var (cutLines, cutArcs) = (cuts.Lines(), cuts.Arcs());
        var pairs = lines.SelectMany((a, i) => lines.Skip(i + 1).Select(b => (A: a, B: b)))
            .Where(p => Math.Abs(p.A.Along.Dot(p.B.Along)) < ParallelCosine).Take(hasOtherEdges ? 60 : 3);
        foreach (var (a, b) in pairs)
        {
            var angle = Elementary.Atan2(a.Along.Cross(b.Along), a.Along.Dot(b.Along));
            foreach (var c in cutLines)
            {
                foreach (var d in cutLines)
                {
                    // The path may run against the drawing.
                    foreach (var sense in new[] { 1, -1 })
                    {
                        var (u, v) = (c.Direction * sense, d.Direction * sense);
                        if (Math.Abs(Elementary.Atan2(u.Cross(v), u.Dot(v)) - angle) > SameAngle)
                        {
                            continue;
                        }

                        foreach (var side in new[] { 1, -1 })
                        {
                            yield return ByLines(mirror, (a, b), (c, d), (u, v), side * radius);
                        }
                    }
                }
            }
        }

        foreach (var (center, r) in arcs)
        {
            foreach (var arc in cutArcs.Where(a => Math.Abs(Math.Abs(a.Radius - r) - (a.IsCompensated ? 0 : radius)) < CoverMm))
            {
                foreach (var rotation in Rotations(lines, cutLines, (center, r), arcs, arc, cutArcs))
                {
                    var rotated = new RigidTransform2(Mirror.None, Angle.FromRadians(rotation), Vector2.Zero).Apply(center);
                    yield return new(mirror, Angle.FromRadians(rotation), arc.Center - rotated);
                }
            }
        }
    }

    private static RigidTransform2 ByLines(
        Mirror mirror,
        ((Point2 At, Vector2 Along) A, (Point2 At, Vector2 Along) B) drawn,
        (CutLine C, CutLine D) cut,
        (Vector2 U, Vector2 V) along,
        double offset)
    {
        var rotation = Elementary.Atan2(drawn.A.Along.Cross(along.U), drawn.A.Along.Dot(along.U));
        var turn = new RigidTransform2(Mirror.None, Angle.FromRadians(rotation), Vector2.Zero);
        var (n, m) = (along.U.Left, along.V.Left);
        var first = n.Dot(cut.C.From - turn.Apply(drawn.A.At)) + (cut.C.IsCompensated ? 0 : offset);
        var second = m.Dot(cut.D.From - turn.Apply(drawn.B.At)) + (cut.D.IsCompensated ? 0 : offset);
        var determinant = n.Cross(m);
        return new(
            mirror,
            Angle.FromRadians(rotation),
            new(((first * m.Y) - (second * n.Y)) / determinant, ((second * n.X) - (first * m.X)) / determinant));
    }

    private static IEnumerable<double> Rotations(
        (Point2 At, Vector2 Along)[] lines,
        IReadOnlyList<CutLine> cutLines,
        (Point2 Center, double Radius) of,
        (Point2 Center, double Radius)[] arcs,
        CutArc on,
        IReadOnlyList<CutArc> cutArcs)
    {
        yield return 0;
        foreach (var along in lines.Take(1).Select(l => l.Along))
        {
            foreach (var direction in cutLines.Take(12).SelectMany(l => new[] { l.Direction, -l.Direction }))
            {
                yield return Elementary.Atan2(along.Cross(direction), along.Dot(direction));
            }
        }

        foreach (var (other, cut) in arcs.Where(a => a.Center.DistanceTo(of.Center) > 1)
            .SelectMany(a => cutArcs.Where(c => Math.Abs(c.Center.DistanceTo(on.Center) - a.Center.DistanceTo(of.Center)) < CoverMm)
                .Select(c => (a, c))))
        {
            var (one, two) = (other.Center - of.Center, cut.Center - on.Center);
            yield return Elementary.Atan2(one.Cross(two), one.Dot(two));
        }
    }

    // Gauss and Newton: shift, turn and, where nobody says it, radius are changed until what is left over is least. Only places that are
    // near count, and nearer from round to round.
    private static OutlineLaying Refine(RigidTransform2 frame, List<OutlinePlace> samples, CutPath cuts, double radius, bool isGiven)
    {
        var (n, capture) = (isGiven ? 3 : 4, 1.0);
        for (var round = 0; round < Rounds; round++)
        {
            var (normal, right, offs) = (new double[n * n], new double[n], new List<double>());
            var pivot = frame.Apply(samples[samples.Count / 2].At);
            foreach (var sample in samples)
            {
                if (LeftOver(frame, sample, cuts, radius, capture, out var foot) is not { } off)
                {
                    continue;
                }

                offs.Add(Math.Abs(off));
                var at = frame.Apply(sample.At);
                var away = foot.DistanceMm > 1e-6 ? (at - foot.At) / foot.DistanceMm : foot.Left;
                double[] row = [away.X, away.Y, (at - pivot).Cross(away), foot.IsCompensated ? 0 : -1];
                for (var i = 0; i < n; i++)
                {
                    right[i] -= row[i] * off;
                    for (var j = 0; j < n; j++)
                    {
                        normal[(i * n) + j] += row[i] * row[j];
                    }
                }
            }

            for (var i = 0; i < n; i++)
            {
                normal[(i * n) + i] += 1e-6;
            }

            var step = Solve(normal, right);
            frame = Moved(frame, pivot, new(step[0], step[1]), step[2]);
            radius += isGiven ? 0 : step[3];
            if (offs.Count == 0)
            {
                break;
            }

            // Beside rounded corners, places are off by anything: they must not pull.
            offs.Sort();
            capture = Math.Min(capture, Math.Max(Math.Max(LeastCaptureMm, capture / 2), OfMost * offs[(int)(Most * offs.Count)]));
        }

        var left = samples.Select(s => new OutlineLaying(frame, radius, 0, 0, 0, 0).LeftOver(s, cuts)).OfType<double>().ToArray();
        return new(
            frame,
            radius,
            (double)left.Length / samples.Count,
            left.Length == 0 ? 0 : Math.Sqrt(left.Average(l => l * l)),
            left.Length == 0 ? 0 : left.Max(Math.Abs),
            0);
    }

    private static RigidTransform2 Moved(RigidTransform2 frame, Point2 pivot, Vector2 shift, double turn)
    {
        var by = RigidTransform2.RotateAbout(pivot, Angle.FromRadians(turn));
        var moved = by.Apply(frame.Apply(Point2.Origin)) + shift;
        return new(frame.Mirror, frame.Rotation + Angle.FromRadians(turn), moved - Point2.Origin);
    }

    // Elimination of a positive definite matrix.
    private static double[] Solve(double[] matrix, double[] right)
    {
        var n = right.Length;
        for (var k = 0; k < n; k++)
        {
            for (var i = k + 1; i < n; i++)
            {
                var factor = matrix[(i * n) + k] / matrix[(k * n) + k];
                for (var j = k; j < n; j++)
                {
                    matrix[(i * n) + j] -= factor * matrix[(k * n) + j];
                }

                right[i] -= factor * right[k];
            }
        }

        for (var i = n - 1; i >= 0; i--)
        {
            for (var j = i + 1; j < n; j++)
            {
                right[i] -= matrix[(i * n) + j] * right[j];
            }

            right[i] /= matrix[(i * n) + i];
        }

        return right;
    }
}
