namespace ErrorMatching.Nc;

/// <content>
/// The strokes of CYCLE83. First depth FDEP or FDPR, then each stroke shorter by DAM until it is DAM; strokes of DAM while more than twice DAM remains; the rest in two halves. Without DAM all
/// strokes are as long as the first, the last one ends at the depth (assumed). VARI=0 lifts at feed to break the chip, VARI=1 leaves the hole.
/// </content>
public sealed partial class NcInterpreter
{
    // Depths from the reference plane at which the strokes end; null where nothing published says what the cycle does. Other cycles have one stroke.
    private List<double>? StrokesOf(CycleCall call, CalledHole hole)
    {
        var total = Math.Abs(hole.Depth - hole.Reference);
        if (call.Number != 83)
        {
            return ++_cycleSteps > MostSteps ? null : [total];
        }

        var first = DepthOf(call, 5) * Unit is { } depth ? (hole.Reference - depth) * (hole.Depth < hole.Reference ? 1 : -1) : double.NaN;
        var less = (call[7] ?? 0) * Unit;
        if (!(first > 0) || !(less >= 0) || (first < less && first < total))
        {
            return null;
        }

        var (strokes, at, stroke) = (new List<double>(), 0.0, first);
        while (_cycleSteps++ < MostSteps)
        {
            at = Sum(at, stroke);
            if (at >= total || stroke == 0)
            {
                // A stroke that the rules would make longer than what remains is none of theirs, but for the first one and where all are alike.
                return at == total || strokes.Count == 0 || less == 0 ? [.. strokes, total] : null;
            }

            strokes.Add(at);
            stroke = less == 0 ? stroke : Math.Max(Sum(stroke, -less), less);
            if (less > 0 && stroke == less && Sum(total, -at) <= Sum(less, less))
            {
                // Halves are always longer than half of the degression, says the rule; of a shorter rest it says nothing.
                return Sum(total, -at) > less ? [.. strokes, at + ((total - at) / 2), total] : null;
            }
        }

        return null;
    }

    private void DrillDeep(CycleCall call, CalledHole hole, IReadOnlyList<double> strokes)
    {
        var (down, feed, removes) = (hole.Depth < hole.Reference ? -1 : 1, _state.Feed, call[11] == 1);
        var lift = LengthOr(call[14], 1);

        // How far above the last depth a rapid ends: stated, or by the depth of the hole.
        var total = Math.Abs(hole.Depth - hole.Reference);
        var ahead = LengthOr(call[16], total <= 30 ? 0.6 : Math.Min(total / 50, 7));
        _state.Feed = feed * (call[10] is > 0 and var factor ? factor : 1);
        for (var i = 0; i < strokes.Count; i++)
        {
            var depth = Sum(hole.Reference, down * strokes[i]);
            ToKnownHeight(MotionKind.Line, i == strokes.Count - 1 ? hole.Depth : depth);
            _state.Feed = feed;
            if (i == strokes.Count - 1)
            {
                break;
            }

            if (removes)
            {
                ToKnownHeight(MotionKind.Rapid, hole.Start);
                ToKnownHeight(MotionKind.Rapid, Sum(depth, -down * ahead));
            }
            else
            {
                ToKnownHeight(MotionKind.Line, Sum(depth, -down * lift));
            }
        }
    }

    private double LengthOr(double? stated, double length) => stated is null or 0 ? length : Math.Abs(stated.Value) * Unit;
}
