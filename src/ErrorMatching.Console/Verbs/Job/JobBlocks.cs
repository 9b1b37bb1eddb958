using System.CommandLine;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job blocks</c>.</summary>
internal sealed class JobBlocks : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job. Its features may lack their blocks." };
    private readonly Option<string> _out = FileOption(
        "--out", "The file to write the job with these blocks to. Without it nothing is written; the job itself is never changed.");

    public JobBlocks()
        : base(
            "blocks",
            "Finds the blocks that cut each feature, by the key points that they lead past.",
            "errormatch job blocks samples/complex-mating/job.json")
    {
        Arguments.Add(_job);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var outcome = BlockRun.Find(arguments.GetRequiredValue(_job), cancellation);
        if (outcome.Result is not { } found)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        // A job with blocks for only some of its features would be unusable.
        var written = found.Refusals.Count == 0 ? arguments.GetValue(_out) : null;
        if (written is not null)
        {
            OutputFile.Write(written, found.JobAt(written), found.Read, cancellation);
        }

        return new JobBlocksAnswer(found, written);
    }
}
