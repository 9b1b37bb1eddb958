using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A match: its report, and the files that it was written to.</summary>
/// <param name="matched">The program with its report.</param>
/// <param name="folder">The folder that the files are in; null if nothing was written.</param>
/// <param name="failure">Why no program is written; null if it is.</param>
internal sealed class MatchAnswer(MatchedProgram matched, string? folder, Failure? failure) : Answer
{
    private const int BlocksShown = 8;

    private readonly MatchReport _report = matched.Report;
    private readonly byte[] _json = matched.ReportJson();

    public override Failure? Failure => failure;

    public override byte[] ToJson() => OutcomeWriter.WithErrors(_json, Failure);

    public override void WriteText(Page page)
    {
        WriteVerdict(page);
        page.Line();
        page.Line($"{_report.Job.Name}: {Summary}");
        page.Line();
        page.Table(
            ["feature", "kind", "largest", "lower", "upper", "uncertainty", "decision"],
            _report.Features.Select(f => (IReadOnlyList<string>)
            [
                f.Name, f.Kind.Word, Show.Signed(f.LargestMm), Show.Signed(f.Tolerance.Band.LowerMm), Show.Signed(f.Tolerance.Band.UpperMm),
                Show.Mm(f.UncertaintyMm), ReportWords.Of(f.Decision),
            ]));
        page.Line();
        page.Table(
            ["point", "feature", "deviation", "correction x", "correction y", "uncompensated", "left over"],
            _report.KeyPoints.Select(p => (IReadOnlyList<string>)
                [
                    p.Point,
                    p.Feature,
                    Show.Signed(p.NormalMm),
                    Show.Signed(p.Correction.X),
                    Show.Signed(p.Correction.Y),
                    Show.Signed(p.UncompensatedMm),
                    ReportNumber.Interval(p.PredictedMm, p.Interval95Mm)]));
        page.Line("Deviation: actual - theoretical of the part, positive where the counterpart needs more material.");
        page.Line("Uncompensated, left over: mating error, counterpart - part, positive where too much material stands; ± 95 % interval.");
        page.Line("Both in mm along the normal from the counterpart's material to its tool; corrections are added in the program's frame.");
        if (_report.Compensation.From == CompensationSource.Counterpart)
        {
            page.Line("Largest: of part - counterpart, which the limits are for.");
        }

        foreach (var sentence in RuleWords.Of(_report).Concat(OutsideWords.Of(_report.Outside)))
        {
            page.Line(sentence);
        }

        page.Line();
        WriteBlocks(page);
        WriteProof(page);
        foreach (var warning in _report.Warnings)
        {
            page.Warning(warning.Message);
        }

        foreach (var note in _report.Notes)
        {
            page.Line("Note: " + note);
        }

        foreach (var sentence in _report.Correction is { } correction ? CorrectionWords.Why(correction) : [])
        {
            page.Line(sentence);
        }

        if (_report.RadiusWearMm is { } wear && _report.Correction is null)
        {
            page.Line($"A tool-radius wear value of {Show.Signed(wear)} mm would do the same.");
        }

        page.Line();
        WriteNext(page);
    }

    private void WriteVerdict(Page page)
    {
        var verdict = _report.Verdict;
        page.Verdict(VerdictWords.Of(verdict), verdict.IsToCut);
        var pair = _report.Pair is { } assembled ? PairWords.Of(assembled, verdict.AllLimits) : null;
        string?[] more = [_report.Acceptance.Sentence, pair, VerdictWords.Risk(_report), VerdictWords.Worst(verdict)];
        foreach (var sentence in more.OfType<string>().Concat(VerdictWords.Trust(verdict)))
        {
            page.Line(sentence);
        }
    }

    private string Summary => _report is { IsUnchanged: true, IsCorrected: true }
        ? "an offset follows the measured " + ReportWords.Of(_report.Compensation.From) + ", the program stays as it is"
        : _report.IsUnchanged ? "nothing to compensate, the program stays as it is"
        : string.Create(
            CultureInfo.InvariantCulture,
            $"{ReportNumber.Count(_report.Program.ChangedWords, "word")} in "
                + $"{ReportNumber.Count(_report.Program.ChangedBlocks, "block")} changed to follow the measured "
                + $"{ReportWords.Of(_report.Compensation.From)}");

    private void WriteBlocks(Page page)
    {
        if (_report.Program.Blocks.Count == 0)
        {
            return;
        }

        page.Table(
            ["line", "before", "after"],
            _report.Program.Blocks.Take(BlocksShown).Select(
                b => (IReadOnlyList<string>)[b.Line.ToString(CultureInfo.InvariantCulture), b.Original, b.Modified]));
        if (_report.Program.Blocks.Count > BlocksShown)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture,
                $"... and {_report.Program.Blocks.Count - BlocksShown} more lines, all of them in the report."));
        }

        page.Line();
    }

    private void WriteProof(Page page)
    {
        var proof = _report.Proof;
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Proof holds: of {ReportNumber.Count(proof.Motions, "motion")} {proof.MovedMotions} moved, none further than "
                + $"{Show.Mm(proof.MaxDeviationFromWantedMm)} mm from where it was wanted; every byte besides is the original's"
                + $"{(proof.Marker is null ? "" : ", but for the marker comment")}."));
        if (proof.Neighbors.Count > 0)
        {
            page.Line(
                $"Neighbors that moved along: {string.Join(", ", proof.Neighbors.Select(n => $"{n.Block} ({ReportWords.Of(n.Role)})"))}.");
        }
    }

    private void WriteNext(Page page)
    {
        if (folder is null)
        {
            page.Line(_report.Acceptance.IsWithheld
                ? "Nothing was written. Add --out DIR to write the report."
                : "Nothing was written. Add --out DIR to write the program and its report.");
            return;
        }

        if (_report.Acceptance.IsWithheld)
        {
            page.Line($"Wrote {In("report.html")} and {In("report.json")}.");
            page.Line(OutsideWords.ToDecide(_report.Outside) ?? "Decide before you cut: see the first line.");
            return;
        }

        var (offsets, run) = _report.Correction?.File is { } file ? ($"{file}, ", $"run {file}, ") : ("", "");
        page.Line($"Wrote {offsets}{_report.Program.File}, {In("report.html")} and {In("report.json")}.");
        if (OutsideWords.ToDecide(_report.Outside) is { } decide)
        {
            page.Line(decide);
        }
        else if (!_report.Verdict.IsToCut)
        {
            page.Line("Decide before you cut: see the first line.");
        }

        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Next: open {In("report.html")} in a browser, {run}cut the counterpart with {_report.Program.File}, measure it, and compare "
                + $"by errormatch verify. Measuring takes about {_report.Time.MeasuringS} s, this calculation took "
                + $"{_report.Time.CalculatingS:0.000} s."));
    }

    private string In(string name) => PathText.In(folder, name);
}
