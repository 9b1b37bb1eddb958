using System.CommandLine;
using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job new</c>.</summary>
internal sealed class JobNew : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();
    private readonly Argument<string> _file = new("FILE") { Description = "The job to write. A file that exists is not overwritten." };

    /// <summary>The verb.</summary>
    public JobNew()
        : base("new", "Writes a commented job to start from.", "errormatch job new mating out/job.json")
    {
        Arguments.Add(_kind);
        Arguments.Add(_file);
    }

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_file);
        OutputFile.Create(file, Encoding.UTF8.GetBytes(arguments.GetRequiredValue(_kind) == JobKind.Freeform ? FreeformTemplate.Text : JobTemplate.Text), cancellation);
        return new JobNewAnswer(file);
    }
}
