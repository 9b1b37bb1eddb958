using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job check</c>.</summary>
internal sealed class JobCheck : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };

    /// <summary>The verb.</summary>
    public JobCheck()
        : base("check", "Says everything that is wrong in a job, or what it asks for.", "errormatch job check samples/complex-mating/job.json") => Arguments.Add(_job);

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation)
    {
        var job = InputFile.Job(arguments.GetRequiredValue(_job));
        _ = InputFile.DialectOf(job);
        foreach (var selector in job.Features.SelectMany(f => f.Blocks))
        {
            _ = BlockSelector.Parse(selector);
        }

        return new JobCheckAnswer(job);
    }
}
