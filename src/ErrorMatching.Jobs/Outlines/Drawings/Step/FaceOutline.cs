using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>The outline of a flat face in the drawing, for finding faces above one another with the same outline.</summary>
internal sealed class FaceOutline
{
    // Curves that are nearer to each other are the same, mm: two free curves are each drawn to ChordMm.
    private const double SameMm = 2 * DrawnCourse.ChordMm;

    private readonly IReadOnlyList<DrawnCurve> _curves;
    private readonly Dictionary<(long X, long Y), List<int>> _middles = [];
    private readonly Point2 _least;
    private readonly Point2 _most;

    /// <summary>Describes the outline of a face.</summary>
    /// <param name="view">Where it is looked at from.</param>
    /// <param name="curves">Its curves, one or more.</param>
    /// <param name="layer">Its layer.</param>
    public FaceOutline(ModelView view, IReadOnlyList<DrawnCurve> curves, string layer)
    {
        (View, _curves, Layer) = (view, curves, layer);
        (_least, _most) = (Middle(curves[0]), Middle(curves[0]));
        for (var c = 0; c < curves.Count; c++)
        {
            var middle = Middle(curves[c]);
            _least = new(Math.Min(_least.X, middle.X), Math.Min(_least.Y, middle.Y));
            _most = new(Math.Max(_most.X, middle.X), Math.Max(_most.Y, middle.Y));
            var cell = CellOf(middle);
            if (!_middles.TryGetValue(cell, out var list))
            {
                _middles[cell] = list = [];
            }

            list.Add(c);
        }
    }

    /// <summary>Where it is looked at from.</summary>
    public ModelView View { get; }

    /// <summary>Its layer.</summary>
    public string Layer { get; }

    /// <summary>How far along the axis of the view the faces with this outline are, mm.</summary>
    public List<double> Heights { get; } = [];

    /// <summary>True if both have the same curves, in whatever order and direction.</summary>
    public bool IsSameAs(FaceOutline other)
    {
        if (View != other.View || _curves.Count != other._curves.Count
            || _least.DistanceTo(other._least) > SameMm || _most.DistanceTo(other._most) > SameMm)
        {
            return false;
        }

        var used = new bool[_curves.Count];
        return other._curves.All(c => Find(c, used));
    }

    private bool Find(DrawnCurve curve, bool[] used)
    {
        var (x, y) = CellOf(Middle(curve));
        for (var i = x - 1; i <= x + 1; i++)
        {
            for (var j = y - 1; j <= y + 1; j++)
            {
                foreach (var k in _middles.GetValueOrDefault((i, j)) ?? [])
                {
                    if (!used[k] && (IsSame(_curves[k], curve) || IsSame(_curves[k], curve.Reversed())))
                    {
                        used[k] = true;
                        return true;
                    }
                }
            }
        }

        return false;
    }

    private static bool IsSame(DrawnCurve one, DrawnCurve other)
    {
        if (one is DrawnArc { IsCircle: true } a && other is DrawnArc { IsCircle: true } b)
        {
            return a.Center.DistanceTo(b.Center) <= SameMm && Math.Abs(a.Radius - b.Radius) <= SameMm;
        }

        return one.GetType() == other.GetType() && new[] { 0, 0.25, 0.5, 0.75, 1 }.All(
            share => At(one, share).DistanceTo(At(other, share)) <= SameMm);
    }

    // A circle may begin anywhere: its center tells it.
    private static Point2 Middle(DrawnCurve curve) => curve is DrawnArc { IsCircle: true } circle ? circle.Center : At(curve, 0.5);

    private static Point2 At(DrawnCurve curve, double share) => curve.AtLength(share * curve.LengthMm);

    private static (long X, long Y) CellOf(Point2 at) => ((long)Math.Floor(at.X / SameMm), (long)Math.Floor(at.Y / SameMm));
}
