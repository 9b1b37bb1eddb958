using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The passes of a finishing program, seen from above.</summary>
/// <remarks>Passes are closer together than the screen can show. Where they are, one of several is drawn.</remarks>
public sealed class SurfacePath
{
    private const int ChordsOfArc = 16;

    // Share of the way that goes on in the same direction, below which a pass ends.
    private const double AheadShare = 0.5;

    // Share of the longest pass that tells a pass from a link between two.
    private const double PassShare = 0.2;

    private readonly IReadOnlyList<IReadOnlyList<Point2>> _long;
    private readonly double _apartMm;

    private SurfacePath(IReadOnlyList<IReadOnlyList<Point2>> passes)
    {
        Passes = passes;
        double[] lengths = [.. passes.Select(LengthOf)];
        var least = PassShare * lengths.DefaultIfEmpty().Max();
        _long = [.. passes.Where((_, i) => lengths[i] >= least)];
        var box = PlotBox.Of(passes.SelectMany(p => p));
        _apartMm = box.IsEmpty ? 0 : (box.Right - box.Left) * (box.High - box.Low) / Math.Max(lengths.Sum(), double.Epsilon);
    }

    /// <summary>All passes, and the links between them.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Passes { get; }

    /// <summary>Reads the cuts of a program. Slow: do not call it on the UI thread.</summary>
    /// <param name="program">Its bytes.</param>
    /// <param name="dialect">Its dialect.</param>
    /// <exception cref="InputException">It cannot be interpreted to its end.</exception>
    public static SurfacePath Of(ReadOnlyMemory<byte> program, NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        const AxisSet Plane = AxisSet.X | AxisSet.Y;
        var (passes, pass) = (new List<IReadOnlyList<Point2>>(), new List<Point2>());
        var path = NcInterpreter.Run(NcProgram.Read(program, dialect.Syntax), dialect);
        if (path.Refusal is { } refusal)
        {
            // What comes before would look like all of it.
            throw new InputException(refusal);
        }

        foreach (var motion in path.Motions)
        {
            if (!motion.IsCut || ((motion.UnknownStart | motion.UnknownEnd) & Plane) != AxisSet.None)
            {
                End();
                continue;
            }

            if (pass.Count == 0 || pass[^1] != Above(motion.Start) || Turns(pass, Above(motion.End)))
            {
                End();
                pass.Add(Above(motion.Start));
            }

            if (motion is { IsArc: true, Plane: CoordinatePlane.XY })
            {
                pass.AddRange(Enumerable.Range(1, ChordsOfArc - 1).Select(i => motion.Arc.At((double)i / ChordsOfArc)));
            }

            pass.Add(Above(motion.End));
        }

        End();
        return new(passes);

        void End()
        {
            if (pass.Count > 1)
            {
                passes.Add([.. pass]);
            }

            pass.Clear();
        }
    }

    /// <summary>The passes to draw: all of them, or one of several where they would cover what is below.</summary>
    /// <param name="scale">Screen units per millimeter.</param>
    /// <param name="leastApart">Smallest distance of two passes, in screen units.</param>
    /// <returns>The passes, and how many there are for each of them.</returns>
    public (IReadOnlyList<IReadOnlyList<Point2>> Passes, int Of) Thinned(double scale, double leastApart)
    {
        var step = _apartMm > 0 ? (int)RoundNumber.AtLeast(Math.Max(1, leastApart / (_apartMm * scale))) : 1;
        return step == 1 ? (Passes, 1) : ([.. _long.Where((_, i) => i % step == 0)], step);
    }

    private static bool Turns(List<Point2> pass, Point2 to) =>
        pass.Count > 1
            && (pass[^1] - pass[^2], to - pass[^1]) is var (before, after)
            && before.Dot(after) < AheadShare * before.Length * after.Length;

    private static double LengthOf(IReadOnlyList<Point2> pass) => pass.Zip(pass.Skip(1)).Sum(p => p.First.DistanceTo(p.Second));

    private static Point2 Above(Point3 place) => new(place.X, place.Y);
}
