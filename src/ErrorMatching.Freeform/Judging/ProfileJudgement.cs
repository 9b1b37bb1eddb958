using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A measured or predicted surface, judged by its profile tolerance (ISO 1101). Lengths in millimeters.</summary>
public sealed record ProfileJudgement
{
    /// <summary>The result in one word.</summary>
    public required ProfileCode Code { get; init; }

    /// <summary>True if the surface is in tolerance.</summary>
    public bool IsWithin => Code == ProfileCode.Within;

    /// <summary>The profile: twice the largest absolute deviation; for a prediction, the one that a measurement is expected to
    /// find.</summary>
    public required double ProfileMm { get; init; }

    /// <summary>Number of points.</summary>
    public required int Points { get; init; }

    /// <summary>Numbers of the points outside the zone, in the order of measuring.</summary>
    public required IReadOnlyList<int> Outside { get; init; }

    /// <summary>Numbers of the measured points in the zone that the guard bands of the rule do not accept.</summary>
    public required IReadOnlyList<int> NotAccepted { get; init; }

    /// <summary>Number of the point with the largest absolute deviation.</summary>
    public required int WorstPoint { get; init; }

    /// <summary>Its deviation, positive out of the material.</summary>
    public required double WorstMm { get; init; }

    /// <summary>The predicted deviation with the largest magnitude anywhere on the surface; null for a measurement, which knows its
    /// points only.</summary>
    public required double? WorstAnywhereMm { get; init; }

    /// <summary>Standard uncertainty of a deviation.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>The probability that every point is in the zone, if the errors of the points are independent (JCGM 106:2012, section
    /// 7).</summary>
    public required double Probability { get; init; }

    /// <summary>Judges a measured surface: each point by its deviation and the rule.</summary>
    /// <param name="tolerance">The tolerance.</param>
    /// <param name="samples">The deviations, at least one, aligned as the tolerance demands.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a measured deviation.</param>
    public static ProfileJudgement OfMeasured(ProfileTolerance tolerance, IReadOnlyList<ErrorSample> samples, double uncertaintyMm)
    {
        ArgumentNullException.ThrowIfNull(tolerance);
        ArgumentNullException.ThrowIfNull(samples);
        double[] deviations = [.. samples.Select(s => s.ErrorMm)];
        var accepted = tolerance.Rule.AcceptanceLimits(tolerance.Limits, uncertaintyMm);
        int[] near = [
            .. samples.Where(s => tolerance.Limits.Contains(s.ErrorMm) && accepted?.Contains(s.ErrorMm) != true).Select(s => s.Point)];
        var judged = Of(tolerance, samples, deviations, uncertaintyMm);
        return judged with
        {
            Code = judged.Outside.Count > 0 ? ProfileCode.Outside : near.Length > 0 ? ProfileCode.NotAccepted : ProfileCode.Within,
            NotAccepted = near,
        };
    }

    /// <summary>Judges a predicted surface: its systematic deviations by the limits, and the surface as a whole by the probability that
    /// every point will be in the zone.</summary>
    /// <remarks>A predicted surface is accepted if that probability is at least 50 % by the simple rule, as for a measured value on its
    /// limit, and at least 1 - risk by a rule with guard bands. Systematic deviations alone would accept any scatter.</remarks>
    /// <param name="tolerance">The tolerance.</param>
    /// <param name="samples">The measured points, at least one.</param>
    /// <param name="deviationsMm">The systematic deviation that is expected at each of them.</param>
    /// <param name="profileMm">The profile that a measurement is expected to find, scatter included.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a predicted deviation, scatter included.</param>
    /// <param name="anywhereMm">Systematic deviations that are expected anywhere on the surface.</param>
    public static ProfileJudgement OfPredicted(
        ProfileTolerance tolerance,
        IReadOnlyList<ErrorSample> samples,
        IReadOnlyList<double> deviationsMm,
        double profileMm,
        double uncertaintyMm,
        IEnumerable<double> anywhereMm)
    {
        ArgumentNullException.ThrowIfNull(tolerance);
        ArgumentNullException.ThrowIfNull(samples);
        ArgumentNullException.ThrowIfNull(deviationsMm);
        var worst = anywhereMm.Select(d => (double?)d).MaxBy(d => Math.Abs(d!.Value));
        var judged = Of(tolerance, samples, deviationsMm, uncertaintyMm);
        return judged with
        {
            Code = judged.Outside.Count > 0 ? ProfileCode.Outside
                : worst is { } between && !tolerance.Limits.Contains(between) ? ProfileCode.OutsideBetween
                : judged.Probability < LeastProbability(tolerance.Rule) ? ProfileCode.NotAccepted
                : ProfileCode.Within,
            ProfileMm = profileMm,
            WorstAnywhereMm = worst,
        };
    }

    /// <summary>The least probability of conformance at which a predicted surface is accepted.</summary>
    public static double LeastProbability(DecisionRule rule)
    {
        ArgumentNullException.ThrowIfNull(rule);
        return rule.RiskPercent is { } risk ? 1 - (risk / 100) : 0.5;
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter json)
    {
        json.Text("code", ProfileWords.Of(Code));
        json.Number("profileUm", ProfileMm * 1000);
        json.Count("points", Points);
        json.Numbers("outside", Outside.Select(p => (double)p));
        json.Numbers("notAccepted", NotAccepted.Select(p => (double)p));
        json.Count("worstPoint", WorstPoint);
        json.Number("worstUm", WorstMm * 1000);
        json.Number("worstAnywhereUm", WorstAnywhereMm * 1000);
        json.Number("uncertaintyUm", UncertaintyMm * 1000);
        json.Exact("probability", Probability);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ProfileJudgement Read(ReportReader json) => new()
    {
        Code = json.Word<ProfileCode>("code", ProfileWords.Of),
        ProfileMm = json.Micrometers("profileUm"),
        Points = json.Count("points"),
        Outside = json.Counts("outside"),
        NotAccepted = json.Counts("notAccepted"),
        WorstPoint = json.Count("worstPoint"),
        WorstMm = json.Micrometers("worstUm"),
        WorstAnywhereMm = json.OptionalNumber("worstAnywhereUm") / 1000,
        UncertaintyMm = json.Micrometers("uncertaintyUm"),
        Probability = json.Number("probability"),
    };

    private static ProfileJudgement Of(
        ProfileTolerance tolerance, IReadOnlyList<ErrorSample> samples, IReadOnlyList<double> deviations, double uncertaintyMm)
    {
        var worst = Enumerable.Range(0, samples.Count).MaxBy(k => Math.Abs(deviations[k]));
        return new()
        {
            Code = ProfileCode.Within,
            ProfileMm = 2 * Math.Abs(deviations[worst]),
            Points = samples.Count,
            Outside = [.. samples.Where((_, k) => !tolerance.Limits.Contains(deviations[k])).Select(s => s.Point)],
            NotAccepted = [],
            WorstPoint = samples[worst].Point,
            WorstMm = deviations[worst],
            WorstAnywhereMm = null,
            UncertaintyMm = uncertaintyMm,
            Probability = Conformance.OfIndependent(
                deviations.Select(d => Conformance.Probability(tolerance.Limits, d, uncertaintyMm)))!.Value,
        };
    }
}
