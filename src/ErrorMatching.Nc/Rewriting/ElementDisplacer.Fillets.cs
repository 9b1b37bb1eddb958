using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <content>Fillets: arcs that join two displaced lines tangentially and must stay tangent.</content>
internal sealed partial class ElementDisplacer
{
    // An unnamed fillet between two displaced flanks must stay tangent to both, or the tool would leave a mark.
    private IEnumerable<ElementWish> WithNeighborFillets(IReadOnlyList<ElementWish> elements)
    {
        for (var i = 0; i < elements.Count; i++)
        {
            _asked.Add(elements[i].Motion);
            yield return elements[i];
            var first = elements[i].Motion + 1;
            var behind = i + 1 < elements.Count ? elements[i + 1].Motion : first;
            if (behind == first || Fillet.Around(_path, first) is not { } around || around != (first, behind - 1))
            {
                continue;
            }

            var (from, to) = (elements[i].End, elements[i + 1].Start);
            for (var motion = first; motion < behind; motion++)
            {
                var fillet = new ElementWish(motion, from, (from + to) / 2, to, IsFillet: true);
                _otherWishes.Add(motion, fillet);
                yield return fillet;
            }
        }
    }

    // Both flanks, offset by the new radius, meet in the new center; its feet on them are the new tangent points. Joints between arcs of
    // the fillet keep their direction from the center.
    private Refusal? Round(ElementWish element)
    {
        if (_rounded.ContainsKey(element.Motion) || Fillet.Around(_path, element.Motion) is not { } fillet
            || !_named.Contains(fillet.First - 1) || !_named.Contains(fillet.Last + 1)
            || CarrierOf(fillet.First - 1).Line is not { } first || CarrierOf(fillet.Last + 1).Line is not { } second)
        {
            return null;
        }

        var motion = _path.Motions[fillet.First];
        var arc = motion.Arc;
        var left = (WishOf(fillet.First - 1).End.Dot(first.Normal) + WishOf(fillet.Last + 1).Start.Dot(second.Normal)) / 2;
        var towardCenter = arc.IsCounterClockwise ? 1 : -1;
        var radius = arc.Radius - (towardCenter * left);
        var center = radius > 0
            ? Intersect.Lines(first.Offset(towardCenter * radius), second.Offset(towardCenter * radius)).Nearest(arc.Center)
            : null;
        if (center is not { } c)
        {
            return At(motion, NcRefusalCodes.ElementFlips, "the fillet is smaller than the displacement of its flanks.");
        }

        _change.Move(fillet.First, motion.Plane, first.Foot(c) - _path.Motions[fillet.First].PlaneStart);
        for (var i = fillet.First; i <= fillet.Last; i++)
        {
            var end = _path.Motions[i].PlaneEnd;
            _rounded.Add(i, new(null, new(c, radius)));
            _change.SetCenter(i, c);
            _change.Move(i + 1, motion.Plane, (i == fillet.Last ? second.Foot(c) : c + ((end - arc.Center).Normalize() * radius)) - end);
        }

        return null;
    }
}
