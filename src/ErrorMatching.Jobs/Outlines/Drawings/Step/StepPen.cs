using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Draws the bounds of flat faces.</summary>
/// <param name="file">The file, for errors.</param>
internal sealed class StepPen(string file) : DrawingPen
{
    // Arcs whose centers and radii differ by less are of one circle, mm: numbers of files are rounded.
    private const double SameCircleMm = 1e-5;

    private FaceEdge? _edge;

    /// <summary>Curves that are points: how many, and the first one.</summary>
    public (int Count, string First) NoLengths { get; private set; } = (0, "");

    /// <summary>Edges inside of their faces: how many, and the first one.</summary>
    public (int Count, string First) Inside { get; private set; } = (0, "");

    /// <inheritdoc/>
    protected override string Entity => _edge!.Entity;

    /// <summary>Draws the bounds of a face.</summary>
    /// <param name="face">The face.</param>
    /// <param name="layer">Its layer.</param>
    /// <param name="view">Where it is looked at from.</param>
    /// <exception cref="InputException">A bound is broken, or not closed.</exception>
    public void Draw(FlatFace face, string layer, ModelView view)
    {
        Layer = layer;
        foreach (var bound in face.ReadBounds())
        {
            List<(DrawnCurve Curve, bool IsInside)> loop = [];
            var first = Curves.Count;
            foreach (var edge in bound)
            {
                _edge = edge;
                var before = Curves.Count;
                Draw(edge, view);
                for (var c = before; c < Curves.Count && edge.Number > 0; c++)
                {
                    Curves[c] = Curves[c] with { Edges = [edge.Number] };
                }

                loop.AddRange(Curves.Skip(before).Select(c => (c, edge.IsInside)));
            }

            CheckClosed(face, [.. loop.Select(c => c.Curve)]);
            Curves.RemoveRange(first, Curves.Count - first);
            Curves.AddRange(Joined([.. loop.Where(c => !c.IsInside).Select(c => c.Curve)]));
            Count(loop.FindAll(c => c.IsInside));
        }
    }

    /// <inheritdoc/>
    public override InputException Fail(string code, string problem) =>
        InputException.At(code, file, $"{_edge!.Entity}: {problem}", _edge.Line);

    /// <inheritdoc/>
    protected override void NoLength() => NoLengths = (NoLengths.Count + 1, NoLengths.Count == 0 ? Entity : NoLengths.First);

    private void Count(List<(DrawnCurve Curve, bool IsInside)> inside)
    {
        if (inside.Count > 0)
        {
            Inside = (Inside.Count + inside.Count, Inside.Count == 0 ? inside[0].Curve.Entity : Inside.First);
        }
    }

    private void Draw(FaceEdge edge, ModelView view)
    {
        switch (edge)
        {
            case StraightEdge line:
                Line(view.Of(line.From), view.Of(line.To));
                break;
            case RoundEdge { IsCircular: true } arc:
                var (x, y) = (view.Of(arc.X), view.Of(arc.Y));
                var sense = x.Cross(y) < 0 ? -1 : 1;
                Arc(view.Of(arc.Center), arc.X.Length, Elementary.Atan2(x.Y, x.X) + (sense * arc.Start), sense * arc.Sweep);
                break;
            case RoundEdge arc:
                new EllipseShape(view.Of(arc.Center), view.Of(arc.X), view.Of(arc.Y), arc.Start, arc.Sweep)
                    .Draw(PlaneMap.Scaling(1, 1), this);
                break;
            case SplineEdge { Curve: var curve }:
                new SplineShape(
                    curve.Knots.Degree,
                    curve.Knots.Values.ToArray(),
                    [.. curve.Poles.ToArray().Select(view.Of)],
                    curve.IsRational ? curve.Weights.ToArray() : null).Draw(PlaneMap.Scaling(1, 1), this);
                break;
            default:
                throw new InvalidOperationException(edge.GetType().Name);
        }
    }

    private void CheckClosed(FlatFace face, DrawnCurve[] loop)
    {
        for (var i = 0; i < loop.Length; i++)
        {
            var (one, next) = (loop[i], loop[(i + 1) % loop.Length]);
            var gap = one.To.DistanceTo(next.From);
            if (!(gap <= OutlineChain.JoinMm))
            {
                throw InputException.At(
                    "open-loop",
                    file,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"{face}: from the end of {one.Entity} to {next.Entity}, a gap of {gap:0.###} mm is left; a closed outline is "
                            + $"expected, to {OutlineChain.JoinMm} mm"),
                    face.Line);
            }
        }
    }

    // CAD systems cut circles into halves. One arc is drawn, as it would be in a drawing.
    private static List<DrawnCurve> Joined(DrawnCurve[] loop)
    {
        List<DrawnCurve> joined = [];
        foreach (var curve in loop)
        {
            if (joined.Count > 0 && Together(joined[^1], curve) is { } arc)
            {
                joined[^1] = arc;
            }
            else
            {
                joined.Add(curve);
            }
        }

        if (joined.Count > 1 && Together(joined[^1], joined[0]) is { } around)
        {
            joined[^1] = around;
            joined.RemoveAt(0);
        }

        return joined;
    }

    private static DrawnArc? Together(DrawnCurve one, DrawnCurve next) =>
        one is DrawnArc a && next is DrawnArc b
            && a.Center.DistanceTo(b.Center) <= SameCircleMm && Math.Abs(a.Radius - b.Radius) <= SameCircleMm
            && Math.Sign(a.Sweep) == Math.Sign(b.Sweep) && Math.Abs(a.Sweep + b.Sweep) <= Math.Tau + 1e-6
            && a.To.DistanceTo(b.From) <= OutlineChain.JoinMm
            ? a with
            {
                Edges = [.. a.Edges.Union(b.Edges)],
                Sweep = Math.Abs(a.Sweep + b.Sweep) > Math.Tau - 1e-6 ? Math.Sign(a.Sweep) * Math.Tau : a.Sweep + b.Sweep,
            }
            : null;
}
