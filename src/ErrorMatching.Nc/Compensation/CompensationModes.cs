using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>How the control compensates at the current motion: side and radius, corners, and its way in.</summary>
internal sealed class CompensationModes(NcPath path, ToolRadii radii, string lead)
{
    private readonly IReadOnlyList<CompensationSwitch> _switches = path.CompensationSwitches;
    private readonly CompensationRule _rule = path.Dialect.Compensation;
    private int _next;
    private CompensationSwitch? _on;

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

    /// <summary>Distance of the tool's center to the left of a motion that begins compensation, mm.</summary>
    /// <param name="motion">The motion.</param>
    /// <param name="left">The distance.</param>
    public Refusal? Find(in NcMotion motion, out double left)
    {
        left = 0;
        if (_on is not { } on)
        {
            return At(
                motion.Block, NcRefusalCodes.CompensationUnfollowed, "cutter compensation is on here by a word that is not followed.");
        }

        var byDiameter = on.Meaning is NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter;
        var radius = !byDiameter ? radii.For(on.Offset) : on.Offset is { } d && !double.IsNaN(d) ? d * on.Unit / 2 : null;
        left = (motion.Has(MotionFlags.CompensationLeft) ? 1 : -1) * (radius ?? 0);
        return radius is not null
            ? null
            : At(
                on.Block,
                NcRefusalCodes.ToolRadiusUnknown,
                "cutter compensation begins, and the tool's radius is not stated. State the radius that the control uses.");
    }

    private Refusal? Apply(in CompensationSwitch found, bool isOn)
    {
        switch (found.Meaning)
        {
            case NcMeaning.Unknown when isOn:
                return At(
                    found.Block, NcRefusalCodes.CompensationStop, $"the control stops at {found.Word} while cutter compensation is on.");
            case NcMeaning.Harmless when isOn:
                return At(
                    found.Block,
                    NcRefusalCodes.CompensationUnfollowed,
                    "another tool radius is selected while cutter compensation is on; the path of the tool's center is not followed.");
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
                        $"{found.Word} changes the side without G40; the path of the tool's center is not followed.");
                }

                _on = found;
                break;
        }

        return null;
    }

    private Refusal At(int block, string code, string message) => BlockRefusal.At(path.Program, block, code, lead + message);
}
