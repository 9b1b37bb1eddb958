using System.Globalization;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Report texts of the kind of a correction.</summary>
public static class CorrectionWords
{
    /// <summary>What to do with the offsets, in a sentence; null if the job allows none, or they are not touched.</summary>
    public static string? ToDo(ReportCorrection? correction)
    {
        if (correction?.File is null)
        {
            return null;
        }

        var file = Path.GetFileName(correction.File);
        var run = correction.Choice.Kind switch
        {
            CorrectionKind.ToolWear => $"The program stays as it is: run {file} before it, which corrects {Of(correction.Choice.Radius!)}.",
            CorrectionKind.WorkOffset => $"The program stays as it is: run {file} before it, which corrects {Of(correction.Choice.Work!)}.",
            _ when IsNothing(correction) => $"Run {file} before it, which takes earlier corrections out of the offsets.",
            _ => $"Run {file} before it, which keeps the earlier corrections of the offsets.",
        };
        return correction.Call is { } call ? $"{run} Another program calls it by \"{call}\"." : run;
    }

    /// <summary>By what the correction is made, and why not by less: a sentence for each kind.</summary>
    public static IEnumerable<string> Why(ReportCorrection correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        foreach (var refused in correction.Choice.Refused)
        {
            yield return $"Not by {Name(refused.Kind)}: {refused.Reason}.";
        }

        if (correction.Choice.IsOffset)
        {
            var (choice, blocks) = (correction.Choice, correction.Choice.ExpectedByBlocks);
            var expected = choice.Expected is { } own
                ? $"an error of {Of(own)} is expected; {(blocks is null ? "blocks cannot follow" : $"by blocks {Of(blocks)}")}"
                : string.Create(
                    CultureInfo.InvariantCulture,
                    $"the boundary is nowhere more than {choice.DifferenceMm:0.0000} mm from where blocks would bring it");
            yield return $"By {Name(correction.Choice.Kind!.Value)}: {expected}.";
        }
    }

    private static string Of(ExpectedError error) => string.Create(
        CultureInfo.InvariantCulture, $"{error.RmsMm:0.0000} mm (rms) and {error.LargestMm:0.0000} at the worst place");

    private static bool IsNothing(ReportCorrection correction) =>
        correction.Totals == OffsetTotals.None;

    private static string Of(RadiusCorrection radius) => string.Create(
        CultureInfo.InvariantCulture, $"the tool's radius in D{radius.Number} by {radius.TotalMm:+0.0000;-0.0000} mm in all");

    private static string Of(WorkOffsetCorrection work) => string.Create(
        CultureInfo.InvariantCulture,
        $"work offset {work.Number} by X{work.Total.XMm:+0.0000;-0.0000;+0.0000} Y{work.Total.YMm:+0.0000;-0.0000;+0.0000} mm")
        + (work.Total.RotationDegrees == 0 ? " in all"
            : string.Create(CultureInfo.InvariantCulture, $" and {work.Total.RotationDegrees:+0.000000;-0.000000} degrees in all"));

    private static string Name(CorrectionKind kind) => kind switch
    {
        CorrectionKind.ToolWear => "the tool's radius",
        CorrectionKind.WorkOffset => "the work offset",
        _ => "blocks",
    };
}
