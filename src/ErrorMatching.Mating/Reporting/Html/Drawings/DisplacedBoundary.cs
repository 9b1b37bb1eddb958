using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Displaces a drawn boundary along its normals. Displaced lines meet where their pieces meet at an angle, as in the
/// program.</summary>
internal static class DisplacedBoundary
{
    // Below this sine of the angle between two pieces, their intersection is meaningless.
    private const double NearlyStraight = 0.02;

    // A corner that would extend farther than this many displacements is cut off.
    private const double LongestCorner = 3;

    /// <summary>The displaced boundary as lines.</summary>
    /// <param name="chains">The boundary, see <see cref="Chains"/>.</param>
    /// <param name="by">The drawn displacement of a feature at one of its vertices, along the normal.</param>
    public static IReadOnlyList<IReadOnlyList<Point2>> Of(
        IReadOnlyList<IReadOnlyList<DrawnFeature>> chains, Func<DrawnFeature, int, double> by) =>
        [.. chains.Select(c => Displace([.. c.SelectMany(f => Pieces(f, by))]))];

    /// <summary>The features in the order of cutting, grouped by touching ends.</summary>
    /// <param name="features">The features in the order of cutting.</param>
    /// <param name="touchMm">Largest distance between touching ends.</param>
    public static IReadOnlyList<IReadOnlyList<DrawnFeature>> Chains(IEnumerable<DrawnFeature> features, double touchMm)
    {
        var chains = new List<List<DrawnFeature>>();
        foreach (var feature in features)
        {
            if (chains.Count > 0 && chains[^1][^1].End.DistanceTo(feature.Start) <= touchMm)
            {
                chains[^1].Add(feature);
            }
            else
            {
                chains.Add([feature]);
            }
        }

        return chains;
    }

    private static IEnumerable<Piece> Pieces(DrawnFeature feature, Func<DrawnFeature, int, double> by) =>
        Enumerable.Range(0, feature.Segments).Select(i => new Piece(
            feature.Vertex(i), feature.Vertex(i + 1), feature.Normal(i), by(feature, i), by(feature, i + 1)));

    private static List<Point2> Displace(Piece[] pieces)
    {
        var line = new List<Point2> { pieces[0].DisplacedStart };
        for (var i = 1; i < pieces.Length; i++)
        {
            AddCorner(line, pieces[i - 1], pieces[i]);
        }

        line.Add(pieces[^1].DisplacedEnd);
        return line;
    }

    private static void AddCorner(List<Point2> line, Piece last, Piece next)
    {
        var (a, b) = (last.Normal, next.Normal);
        var sine = a.Cross(b);
        var size = Math.Max(Math.Abs(last.ToBy), Math.Abs(next.FromBy));
        if (Math.Abs(sine) > NearlyStraight)
        {
            // The vector whose components along both normals are the displacements.
            var to = new Vector2((last.ToBy * b.Y) - (next.FromBy * a.Y), (next.FromBy * a.X) - (last.ToBy * b.X)) / sine;
            if (to.Length <= LongestCorner * size && last.End == next.Start)
            {
                line.Add(next.Start + to);
                return;
            }
        }

        line.Add(last.DisplacedEnd);
        line.Add(next.DisplacedStart);
    }

    private sealed record Piece(Point2 Start, Point2 End, Vector2 Normal, double FromBy, double ToBy)
    {
        public Point2 DisplacedStart => Start + (Normal * FromBy);

        public Point2 DisplacedEnd => End + (Normal * ToBy);
    }
}
