using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Carries a refusal out of the layout of a plan; it never leaves the planner.</summary>
internal sealed class PlanRefusedException(Refusal refusal) : Exception(refusal.Message)
{
    public Refusal Refusal { get; } = refusal;

    public static PlanRefusedException TooFew(string what, int asked, int needed, int breaks) => new(new(
        "too-few-points",
        string.Create(
            CultureInfo.InvariantCulture,
            $"{asked} {what} are asked for, but ends and {breaks} curvature breaks alone need {needed}: ask for at least {needed}.")));

    public static PlanRefusedException NoRoom(string where) => new(new(
        "no-room",
        $"{where} has no room for points: trimming leaves less than twice the "
            + $"{PlanLayout.TrimSetInMm.ToString(CultureInfo.InvariantCulture)} mm that are kept from its edges. Measure fewer "
            + $"curves, or another surface."));
}
