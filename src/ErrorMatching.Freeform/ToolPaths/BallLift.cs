using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Raises the ball where it would gouge, or refuses the path.</summary>
/// <param name="context">What the path is planned with.</param>
/// <param name="gouges">Tests for gouges.</param>
internal sealed class BallLift(PlanningContext context, GougeTest gouges)
{
    // Heights are found to this length and rounded up.
    private const double RaiseStep = 0.0001;

    /// <summary>Raises the points along Z until the ball touches the surface and cuts nothing else.</summary>
    public CutPiece? Raise(CutPiece piece, CenterLine line)
    {
        var raised = new CenterLine();
        for (var i = 0; i < line.Count; i++)
        {
            var end = LiftOutOfGouges(line.Places[i], line.Centers[i], line.Normals[i]);
            if (i > 0 && !Refine(line.Places[i - 1], line.Places[i], raised, end, 0))
            {
                return null;
            }

            if (end is not { } point)
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
        var exact = context.Offset.At(place.X, place.Y);
        if (depth > 12 || !gouges.Gouges(GougeTest.Middle(raised.Centers[^1], next.Center), exact.Normal))
        {
            return true;
        }

        if (LiftOutOfGouges(place, context.Rounding.Nearest(exact.Center), exact.Normal) is not { } middle
            || !Refine(from, place, raised, middle, depth + 1))
        {
            return false;
        }

        raised.Add(place, middle.Center, exact.Normal, Math.Max(middle.Raised, RaiseStep));
        return Refine(place, to, raised, end, depth + 1);
    }

    private (Point3 Center, double Raised)? LiftOutOfGouges(Point2 place, Point3 center, Vector3 normal)
    {
        if (!gouges.Gouges(center, normal))
        {
            return (center, 0);
        }

        var (low, high) = (0.0, RaiseStep);
        while (high <= context.MostRaisedMm && gouges.Gouges(center + new Vector3(0, 0, high), normal))
        {
            (low, high) = (high, 2 * high);
        }

        while (high - low > RaiseStep / 2)
        {
            var middle = (low + high) / 2;
            (low, high) = gouges.Gouges(center + new Vector3(0, 0, middle), normal) ? (middle, high) : (low, middle);
        }

        var up = Math.Ceiling(high / context.Rounding.IncrementMm) * context.Rounding.IncrementMm;
        if (up <= context.MostRaisedMm + context.Rounding.IncrementMm)
        {
            return (context.Rounding.Nearest(center + new Vector3(0, 0, up)), up);
        }

        var depth = gouges.DepthMm(center, normal);
        context.Refusal ??= new("ball-does-not-fit", string.Create(
            CultureInfo.InvariantCulture,
            $"at {context.Named(place)} the ball of {2 * context.Offset.RadiusMm} mm would cut {depth:0.0000} mm too deep. {Fitting()}, or "
                + $"leave that part out of the surface."));
        return null;
    }

    // The smallest concave radius determines the ball if it is smaller than the ball. Otherwise another part of the surface is gouged.
    private string Fitting()
    {
        const int Samples = 100;
        var (surface, hollow) = (context.Offset.Surface, 0.0);
        var spline = surface.Spline;
        for (var i = 0; i <= Samples; i++)
        {
            for (var j = 0; j <= Samples; j++)
            {
                var (u, v) = (
                    spline.KnotsU.Start + ((spline.KnotsU.End - spline.KnotsU.Start) * i / Samples),
                    spline.KnotsV.Start + ((spline.KnotsV.End - spline.KnotsV.Start) * j / Samples));
                var (largest, smallest) = spline.At(u, v).PrincipalCurvatures;
                var its = surface.Outside > 0 ? largest : -smallest;
                hollow = surface.Region.Contains(u, v) && its > hollow ? its : hollow;
            }
        }

        return hollow * context.Offset.DistanceMm > 1 && (1 / hollow) > context.Offset.StockMm
            ? string.Create(
                CultureInfo.InvariantCulture,
                $"Use a ball of at most {2 * ((1 / hollow) - context.Offset.StockMm):0.00} mm, twice the smallest hollow radius of the "
                    + $"surface")
            : "Use a smaller ball: it touches another part of the surface";
    }
}
