using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>How the control compensates at the current motion: side and radius, corners, and its way in.</summary>
internal sealed class CompensationModes(NcPath path, ToolRadii radii, string lead)
{
    private readonly IReadOnlyList<CompensationSwitch> _switches = path.CompensationSwitches;
    private readonly CompensationRule _rule = path.Dialect.Compensation;
    private readonly HashSet<int> _sharpEnds = [];
    private int _next;
    private CompensationSwitch? _on;
    private CompensationSwitch? _lead;
    private CompensationSwitch? _unfollowed;

    /// <summary>The control's way in.</summary>
    public CompensationStart Start { get; private set; } = path.Dialect.Compensation.Start;

    /// <summary>True if the way in and out is as stated only where it needs not go around the contour's end.</summary>
    public bool StartsOtherwiseAround { get; private set; }

    /// <summary>Outside corners that turn by up to the rule's angle.</summary>
    public CompensationCorner Corners { get; private set; } = path.Dialect.Compensation.OutsideCorners;

    /// <summary>Outside corners that turn further.</summary>
    public CompensationCorner SharpCorners { get; private set; } = path.Dialect.Compensation.SharpCorners;

    /// <summary>Applies the switches before a motion.</summary>
    /// <param name="motion">Position of the motion.</param>
    /// <param name="isOn">True if the tool's center is led beside the contour.</param>
    public Refusal? Advance(int motion, bool isOn)
    {
        while (_next < _switches.Count && _switches[_next].Joint <= motion)
        {
            if (Apply(_switches[_next++], isOn) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    /// <summary>How a motion leads to a contour or away from it; null if its block does not say.</summary>
    public CompensationSwitch? LeadOf(int motion) => _lead is { } lead && MotionOf(lead) == motion ? lead : null;

    /// <summary>True if the outside corner at the end of a motion goes on to the intersection, whatever others do.</summary>
    public bool IsSharpAtEndOf(int motion) => _sharpEnds.Contains(motion);

    /// <summary>Distance of the tool's center to the left of a motion that begins compensation, mm.</summary>
    /// <param name="motion">The motion.</param>
    /// <param name="index">Its position.</param>
    /// <param name="left">The distance.</param>
    public Refusal? Find(in NcMotion motion, int index, out double left)
    {
        left = 0;
        if (_unfollowed is { } word && MotionOf(word) == index)
        {
            return Unfollowed(word);
        }

        if (_on is not { } on)
        {
            return At(
                motion.Block, NcRefusalCodes.CompensationUnfollowed, "cutter compensation is on here by a word that is not followed.");
        }

        var byDiameter = on.Meaning is NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter;
        var radius = byDiameter ? on.Offset * on.Unit / 2 : on.Radius ?? radii.For(on.Offset);
        radius += on.Oversize;
        left = (motion.Has(MotionFlags.CompensationLeft) ? 1 : -1) * (radius ?? 0);
        return radius is { } known && !double.IsNaN(known)
            ? null
            : At(
                on.Block,
                NcRefusalCodes.ToolRadiusUnknown,
                "cutter compensation begins, and the tool's radius is not stated. State the radius that the control uses.");
    }

    private Refusal? Apply(in CompensationSwitch found, bool isOn)
    {
        if (found.Kind != SwitchKind.Switch)
        {
            return !isOn ? null
                : found.Kind == SwitchKind.Stop ? At(
                    found.Block, NcRefusalCodes.CompensationStop, $"the control stops at {found.Word} while cutter compensation is on.")
                : At(
                    found.Block,
                    NcRefusalCodes.CompensationUnfollowed,
                    "another tool radius is selected while cutter compensation is on; the path of the tool's center is not followed.");
        }

        switch (found.Meaning)
        {
            case NcMeaning.CompensationUnfollowed when isOn:
                return Unfollowed(found);
            case NcMeaning.CompensationUnfollowed:
                _unfollowed = found;
                break;
            case NcMeaning.CompensationSharpCorner:
                _sharpEnds.Add(MotionOf(found));
                break;
            case NcMeaning.Approach or NcMeaning.Departure or (>= NcMeaning.ApproachTangent and <= NcMeaning.DepartureNormal):
                _lead = found;
                break;
            case NcMeaning.CompensationOff:
                _on = null;
                break;
            case NcMeaning.CompensationRoundCorners:
                (Corners, SharpCorners) = (CompensationCorner.Arc, CompensationCorner.Arc);
                break;
            case NcMeaning.CompensationSharpCorners:
                (Corners, SharpCorners) = (CompensationCorner.Intersection, _rule.SharpCorners);
                break;
            case NcMeaning.CompensationNormalEntry:
                StartsOtherwiseAround = false;
                break;
            case NcMeaning.CompensationOtherEntry:
                StartsOtherwiseAround = true;
                break;
            case NcMeaning.CompensationLeft or NcMeaning.CompensationRight
                or NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter:
                if (_on is { } before && isOn && before.Meaning != found.Meaning)
                {
                    return At(
                        found.Block,
                        NcRefusalCodes.CompensationUnfollowed,
                        $"{found.Word} changes the side while cutter compensation is on; the path of the tool's center is not followed.");
                }

                _on = found;
                break;
        }

        return null;
    }

    // The motion of the word's own block: a rounding that waited for it comes first.
    private int MotionOf(in CompensationSwitch word) =>
        path.IsInsertedCorner(word.Joint) ? word.Joint + 1 : word.Joint;

    private Refusal Unfollowed(in CompensationSwitch word) => At(
        word.Block,
        NcRefusalCodes.CompensationUnfollowed,
        $"{word.Word} acts here while cutter compensation is on, and how the control then leads the tool's center is not followed.");

    private Refusal At(int block, string code, string message) => BlockRefusal.At(path.Program, block, code, lead + message);
}
