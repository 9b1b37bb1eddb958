using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <content>Checks centers against the whole surface for gouges, and raises them or refuses the path.</content>
internal sealed partial class PathPlanning
{
    // Heights are found to this length and rounded up.
    private const double RaiseStep = 0.0001;

    // The most that may be left where the ball does not fit: the stock of the stage or the scallop, whichever is larger.
    private double MostRaised => Math.Max(_toolpath.ScallopMm, _offset.StockMm);

    // A line that has not been raised is within the chordal error of the exact offset. If the ball rolls freely on the exact offset,
    // nothing is nearer than that.
    private bool Gouges(CenterLine line)
    {
        var centers = line.Centers;
        var places = line.Places;
        for (var i = 0; i < centers.Length; i++)
        {
            var isFree = RollsAt(places[i]);
            if (!isFree && Gouges(centers[i], line.Normals[i]))
            {
                return true;
            }

            if (i + 1 < centers.Length
                && !(isFree && IsInFreePart(places[i + 1]))
                && Gouges(Middle(centers[i], centers[i + 1]), Between(line.Normals[i], line.Normals[i + 1])))
            {
                return true;
            }
        }

        return false;
    }

    private bool RollsAt(Point2 place)
    {
        if (!IsInFreePart(place))
        {
            _free = _rolling.FreeAround(place.X, place.Y);
        }

        return _free is not null;
    }

    private bool IsInFreePart(Point2 place) =>
        _free is var (from, to) && place.X >= from.X && place.Y >= from.Y && place.X <= to.X && place.Y <= to.Y;

    private bool Gouges(Point3 center, Vector3 normal) => _tree.IsNearer(center, normal, NearestMm);

    private static Point3 Middle(Point3 a, Point3 b) => a + ((b - a) * 0.5);

    // The unit normal halfway between two.
    private static Vector3 Between(Vector3 a, Vector3 b)
    {
        var sum = a + b;
        return sum * (1 / Math.Max(1e-9, sum.Length));
    }

    /// <summary>Raises the points along Z until the ball touches the surface and cuts nothing else.</summary>
    private CutPiece? Raise(CutPiece piece, CenterLine line)
    {
        var raised = new CenterLine();
        for (var i = 0; i < line.Count; i++)
        {
            if (i > 0 && !Refine(line.Places[i - 1], line.Places[i], raised, Free(line.Places[i], line.Centers[i], line.Normals[i]), 0))
            {
                return null;
            }

            if (Free(line.Places[i], line.Centers[i], line.Normals[i]) is not { } point)
            {
                return null;
            }

            raised.Add(line.Places[i], point.Center, line.Normals[i], point.Raised);
        }

        line.Clear();
        for (var i = 0; i < raised.Count; i++)
        {
            line.Add(raised.Places[i], raised.Centers[i], raised.Normals[i], raised.Raised[i]);
        }

        return piece with { Centers = line.Centers.ToArray() };
    }

    // Inserts points between two as long as the ball would gouge at the middle.
    private bool Refine(Point2 from, Point2 to, CenterLine raised, (Point3 Center, double Raised)? end, int depth)
    {
        if (end is not { } next)
        {
            return false;
        }

        var place = from.Lerp(to, 0.5);
        var exact = _offset.At(place.X, place.Y);
        if (depth > 12 || !Gouges(Middle(raised.Centers[^1], next.Center), exact.Normal))
        {
            return true;
        }

        if (Free(place, _rounding.Nearest(exact.Center), exact.Normal) is not { } middle || !Refine(from, place, raised, middle, depth + 1))
        {
            return false;
        }

        raised.Add(place, middle.Center, exact.Normal, Math.Max(middle.Raised, RaiseStep));
        return Refine(place, to, raised, end, depth + 1);
    }

    private (Point3 Center, double Raised)? Free(Point2 place, Point3 center, Vector3 normal)
    {
        if (!Gouges(center, normal))
        {
            return (center, 0);
        }

        var (low, high) = (0.0, RaiseStep);
        while (high <= MostRaised && Gouges(center + new Vector3(0, 0, high), normal))
        {
            (low, high) = (high, 2 * high);
        }

        while (high - low > RaiseStep / 2)
        {
            var middle = (low + high) / 2;
            (low, high) = Gouges(center + new Vector3(0, 0, middle), normal) ? (middle, high) : (low, middle);
        }

        var up = Math.Ceiling(high / _rounding.IncrementMm) * _rounding.IncrementMm;
        if (up <= MostRaised + _rounding.IncrementMm)
        {
            return (_rounding.Nearest(center + new Vector3(0, 0, up)), up);
        }

        var depth = _offset.DistanceMm - _tree.DistanceBelow(center, normal, _offset.DistanceMm);
        _refusal ??= new("ball-does-not-fit", string.Create(
            CultureInfo.InvariantCulture,
            $"at {Named(place)} the ball of {2 * _offset.RadiusMm} mm would cut {depth:0.0000} mm too deep. {Fitting()}, or leave that "
                + $"part out of the surface."));
        return null;
    }

    // The smallest concave radius determines the ball if it is smaller than the ball. Otherwise another part of the surface is gouged.
    private string Fitting()
    {
        const int Samples = 100;
        var (spline, hollow) = (_offset.Surface.Spline, 0.0);
        for (var i = 0; i <= Samples; i++)
        {
            for (var j = 0; j <= Samples; j++)
            {
                var (u, v) = (
                    spline.KnotsU.Start + ((spline.KnotsU.End - spline.KnotsU.Start) * i / Samples),
                    spline.KnotsV.Start + ((spline.KnotsV.End - spline.KnotsV.Start) * j / Samples));
                var (largest, smallest) = spline.At(u, v).PrincipalCurvatures;
                var its = _offset.Surface.Outside > 0 ? largest : -smallest;
                hollow = _offset.Surface.Region.Contains(u, v) && its > hollow ? its : hollow;
            }
        }

        return hollow * _offset.DistanceMm > 1 && (1 / hollow) > _offset.StockMm
            ? string.Create(
                CultureInfo.InvariantCulture,
                $"Use a ball of at most {2 * ((1 / hollow) - _offset.StockMm):0.00} mm, twice the smallest hollow radius of the surface")
            : "Use a smaller ball: it touches another part of the surface";
    }

    private Refusal? Impossible(CenterLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            var normal = line.Normals[i];
            if (!line.Centers[i].IsFinite || !(normal.Length > 0.5))
            {
                return new(
                    "no-normal",
                    $"at {Named(line.Places[i])} the surface has no normal, so that no tool can be laid against it. Repair the surface, "
                        + $"or trim it there.");
            }

            if (normal.Z < -1e-6)
            {
                return new(
                    "faces-down",
                    $"at {Named(line.Places[i])} the surface faces down, where a tool along Z does not reach. Turn the part, or state "
                        + $"\"outside\" if the material lies on the other side.");
            }
        }

        return null;
    }

    /// <summary>An edge inside the surface, where the normal jumps. The center would have to roll around it.</summary>
    private Refusal? EdgeInSurface()
    {
        var spline = _offset.Surface.Spline;
        return EdgeAt(spline.KnotsU, spline.KnotsV, (along, across) => new(across, along))
            ?? EdgeAt(spline.KnotsV, spline.KnotsU, (along, across) => new(along, across));
    }

    private Refusal? EdgeAt(KnotVector knots, KnotVector along, Func<double, double, Point2> place)
    {
        const int Samples = 32;
        foreach (var knot in knots.Breaks)
        {
            if (knots.Multiplicity(knot) < knots.Degree || knot <= knots.Start || knot >= knots.End)
            {
                continue;
            }

            for (var i = 0; i <= Samples; i++)
            {
                var t = along.Start + ((along.End - along.Start) * i / Samples);
                var (before, behind) = (place(t, knot - (1e-9 * (knots.End - knots.Start))), place(t, knot));
                var turn = (_offset.At(before.X, before.Y).Normal - _offset.At(behind.X, behind.Y).Normal).Length;
                if (turn * _offset.DistanceMm > 0.5 * _toolpath.ChordMm)
                {
                    return new("edge-in-surface", string.Create(
                        CultureInfo.InvariantCulture,
                        $"at {Named(behind)} the surface has an edge: its normal turns by "
                            + $"{2 * Math.Asin(Math.Min(1, turn / 2)) * 180 / Math.PI:0.000} degrees at once. Give the faces on both "
                                + $"sides as "
                            + $"surfaces of their own."));
                }
            }
        }

        return null;
    }
}
