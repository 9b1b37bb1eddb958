using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A circle as a pass cuts it, in the program's frame.</summary>
/// <param name="Path">The circle of the tool's path.</param>
/// <param name="Boundary">The resulting circle: a tool radius larger or smaller, or the same under cutter compensation.</param>
/// <param name="Rays">Unit vectors from the center to each key point.</param>
internal sealed record CutCircle(Circle2 Path, Circle2 Boundary, IReadOnlyList<Vector2> Rays)
{
    /// <summary>The circle of a cut whose motions are arcs of one.</summary>
    public static CutCircle Of(FeatureCut cut)
    {
        var motion = cut.Path.Motions[cut.Pass.First];
        var isOutside = cut.Pass.Feet[0].MaterialIsLeft == (motion.Kind == MotionKind.ArcClockwise);
        var aside = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight) ? 0 : cut.ToolDiameterMm / 2;

        // The normals point from the material to the tool: inward if the material is outside.
        return new(
            motion.Arc.Circle,
            new(motion.Arc.Center, Math.Max(0, motion.Arc.Radius + (isOutside ? aside : -aside))),
            [.. cut.Pass.Feet.Select(f => isOutside ? -f.Normal : f.Normal)]);
    }

    /// <summary>The boundary points at the key points, each moved by its correction.</summary>
    public Point2[] Moved(IReadOnlyList<Vector2> corrections) =>
        [.. Rays.Select((ray, i) => Boundary.Center + (ray * Boundary.Radius) + corrections[i])];

    /// <summary>The wishes that change the boundary's circle; path and boundary share the center's shift and the radius's growth. Ends
    /// move along their own rays, so tangent lead-ins and lead-outs move only across their direction. A wish for a one-block circle gives a
    /// diameter: its middle is the opposite point of the new circle.</summary>
    public IEnumerable<ElementWish> Wishes(FeatureCut cut, Circle2 wanted)
    {
        var (shift, radius) = (wanted.Center - Boundary.Center, Path.Radius + (wanted.Radius - Boundary.Radius));
        foreach (var i in FeaturePass.Moving(cut.Path, cut.Pass.First, cut.Pass.Last))
        {
            var arc = cut.Path.Motions[i].Arc;
            if (Math.Abs(arc.Sweep.Degrees) > 359.9)
            {
                yield return OfOneBlock(i, arc, InWholeIncrements(shift, cut.Path.Dialect), radius);
            }
            else
            {
                yield return new(
                    i,
                    Along(arc.StartAngle, shift, radius),
                    Along(arc.StartAngle + (arc.Sweep * 0.5), shift, radius),
                    Along(arc.StartAngle + arc.Sweep, shift, radius));
            }
        }
    }

    // From the old path circle to the new one along a ray of the old center.
    private Vector2 Along(Angle direction, Vector2 shift, double radius)
    {
        var ray = Vector2.FromDirection(direction);
        var across = shift.Cross(ray);
        return ray * (shift.Dot(ray) + Math.Sqrt(Math.Max(0, (radius * radius) - (across * across))) - Path.Radius);
    }

    // A one-block circle starts and ends at the same point. Both ends are moved off their ray by less than a word can express, so that
    // they take the wish as it is and do not slide along lead-in and lead-out independently. A shift straight across the diameter would
    // look like no shift at both ends, so it gets a tiny component along the diameter.
    private ElementWish OfOneBlock(int motion, Arc2 arc, Vector2 shift, double radius)
    {
        const double Told = 1e-8, BesideRay = 2e-6;
        var ray = Vector2.FromDirection(arc.StartAngle);
        var told = shift.Length > Told && Math.Abs(shift.Dot(ray)) < Told ? shift + (ray * (Told - shift.Dot(ray))) : shift;
        var end = Along(arc.StartAngle, told, radius) + (ray.Left * BesideRay);
        return new(motion, end, (told * 2) - end, end);
    }

    // At the far side of such a circle the errors of center and radius add up, so round the center to what a word can express.
    private static Vector2 InWholeIncrements(Vector2 shift, NcDialect dialect)
    {
        var increment = Elementary.Pow(10, -dialect.MetricDecimals);
        return new(Math.Round(shift.X / increment) * increment, Math.Round(shift.Y / increment) * increment);
    }
}
