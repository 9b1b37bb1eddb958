using System.CommandLine;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell show</c>.</summary>
internal sealed class CellShow : CellVerb
{
    private readonly IdArgument _id = new();
    private readonly Option<string> _out = new("--out")
    {
        Description = "The folder to write measurement, programs and report to.",
        HelpName = "DIR"
    };

    public CellShow()
        : base(
            "show",
            "Shows what became of one file, step by step, and writes its measurement, programs and report.",
            "errormatch cell show samples/cell/cell.json 1 --out out")
    {
        Arguments.Add(_id);
        Options.Add(_out);
    }

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithStoreToRead(settings, store => Show(settings, store, arguments, cancellation));

    private CellShowAnswer Show(CellSettings settings, CellStore store, ParseResult arguments, CancellationToken cancellation)
    {
        var correction = new CorrectionDecisions(store).Demand(arguments.GetRequiredValue(_id));
        var folder = arguments.GetValue(_out);
        var files = folder is null
            ? []
            : CorrectionFiles.Read(store, correction).Select(f => (Path: Path.Combine(folder, f.Name), f.Bytes, f.Notice)).ToArray();
        if (files.Length > 0)
        {
            OutputFile.WriteAll([.. files.Select(f => (f.Path, f.Bytes))], [settings.File], () => true, cancellation);
        }

        return new CellShowAnswer(
            correction,
            store.Corrections.StepsOf(correction.Id),
            [.. files.Select(f => f.Path)],
            [.. files.Select(f => f.Notice?.Sentence).OfType<string>()]);
    }
}
