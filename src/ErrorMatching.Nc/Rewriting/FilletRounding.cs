using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves fillets: arcs that join two displaced lines tangentially and must stay tangent.</summary>
internal sealed class FilletRounding(DisplacedElements elements, PathChange change)
{
    private readonly NcPath _path = change.Path;

    /// <summary>Moves the fillet that an element belongs to. Both flanks, offset by the new radius, meet in the new center; its feet on
    /// them are the new tangent points. Joints between arcs of the fillet keep their direction from the center.</summary>
    /// <returns>The reason why it cannot stay tangent, or null.</returns>
    public Refusal? Round(ElementWish element)
    {
        if (elements.IsRounded(element.Motion) || Fillet.Around(_path, element.Motion) is not { } fillet
            || !elements.Contains(fillet.First - 1) || !elements.Contains(fillet.Last + 1)
            || elements.CarrierOf(fillet.First - 1).Line is not { } first || elements.CarrierOf(fillet.Last + 1).Line is not { } second)
        {
            return null;
        }

        var motion = _path.Motions[fillet.First];
        var arc = motion.Arc;
        var (before, behind) = (elements.WishOf(fillet.First - 1), elements.WishOf(fillet.Last + 1));
        var left = (before.End.Dot(first.Normal) + behind.Start.Dot(second.Normal)) / 2;
        var towardCenter = arc.IsCounterClockwise ? 1 : -1;
        var radius = arc.Radius - (towardCenter * left);
        var center = radius > 0
            ? Intersect.Lines(first.Offset(towardCenter * radius), second.Offset(towardCenter * radius)).Nearest(arc.Center)
            : null;
        if (center is not { } c)
        {
            return elements.At(motion, NcRefusalCodes.ElementFlips, "the fillet is smaller than the displacement of its flanks.");
        }

        change.Move(fillet.First, motion.Plane, first.Foot(c) - _path.Motions[fillet.First].PlaneStart);
        for (var i = fillet.First; i <= fillet.Last; i++)
        {
            var end = _path.Motions[i].PlaneEnd;
            elements.Round(i, new(c, radius));
            change.SetCenter(i, c);
            change.Move(i + 1, motion.Plane, (i == fillet.Last ? second.Foot(c) : c + ((end - arc.Center).Normalize() * radius)) - end);
        }

        return null;
    }
}
