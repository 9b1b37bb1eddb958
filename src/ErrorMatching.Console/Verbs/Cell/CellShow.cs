using System.CommandLine;
using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell show</c>.</summary>
internal sealed class CellShow : CellVerb
{
    private readonly IdArgument _id = new();
    private readonly Option<string> _out = new("--out") { Description = "The folder to write measurement, programs and report to.", HelpName = "DIR" };

    /// <summary>The verb.</summary>
    public CellShow()
        : base("show", "Shows what became of one file, step by step, and writes its measurement, programs and report.", "errormatch cell show samples/cell/cell.json 1 --out out")
    {
        Arguments.Add(_id);
        Options.Add(_out);
    }

    /// <inheritdoc/>
    protected override Outcome Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) => WithExistingStore(settings, store => Show(settings, store, arguments, cancellation));

    private CellShowAnswer Show(CellSettings settings, CellStore store, ParseResult arguments, CancellationToken cancellation)
    {
        var correction = new CorrectionDecisions(store).Demand(arguments.GetRequiredValue(_id));
        var folder = arguments.GetValue(_out);
        var files = folder is null ? [] : Files(correction, folder).ToArray();
        if (files.Length > 0)
        {
            OutputFile.WriteAll([.. files.Select(f => (f.Path, (ReadOnlyMemory<byte>)store.Content(f.Sha256)))], [settings.File], () => true, cancellation);
        }

        return new CellShowAnswer(correction, store.StepsOf(correction.Id), [.. files.Select(f => f.Path)]);
    }

    // Names that come from a gauge or a machine lead nowhere else; the number in front keeps two corrections apart.
    private static IEnumerable<(string Path, string Sha256)> Files(Correction correction, string folder)
    {
        var number = correction.Id.ToString(CultureInfo.InvariantCulture);
        var program = correction.Program ?? "program.nc";
        return new (string Name, string? Sha256)[]
        {
            ($"{number}-measurement-{Plain(correction.FileName)}", correction.Code == FileSource.TooLarge ? null : correction.MeasurementSha256),
            ($"{number}-job.json", correction.JobSha256),
            ($"{number}-base-{program}", correction.BaseSha256),
            ($"{number}-previous-{program}", correction.PreviousSha256),
            ($"{number}-report.json", correction.ReportSha256),
            ($"{number}-report.html", correction.PageSha256),
            ($"{number}-{program}", correction.ProgramSha256),
        }.Where(f => f.Sha256 is not null).Select(f => (Path.Combine(folder, f.Name), f.Sha256!));
    }

    private static string Plain(string name) => string.Concat(name.Select(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '-' or '_' ? c : '_'));
}
