using System.CommandLine;
using System.Runtime.CompilerServices;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job new</c>.</summary>
internal sealed class JobNew : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();
    private readonly Argument<string> _file = new("FILE") { Description = "The job to write. A file that exists is not overwritten." };

    public JobNew()
        : base("new", "Writes a commented job, or configuration of a cell, to start from.", "errormatch job new mating out/job.json")
    {
        Arguments.Add(_kind);
        Arguments.Add(_file);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_file);
        var kind = arguments.GetRequiredValue(_kind);
        OutputFile.Create(file, Encoding.UTF8.GetBytes(TextOf(kind)), cancellation);
        return new JobNewAnswer(file, kind == JobKind.Cell ? "cell check" : "job check");
    }

    private static string TextOf(string kind) => kind switch
    {
        JobKind.Freeform => FreeformTemplate.Text,
        JobKind.Cell => CellText(),
        _ => JobTemplate.Text,
    };

    // A method of its own, so that a job does not load the cell.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static string CellText() => CellTemplate.Text;
}
