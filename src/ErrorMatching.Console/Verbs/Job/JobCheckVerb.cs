using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job check</c>.</summary>
internal sealed class JobCheckVerb : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };

    public JobCheckVerb()
        : base(
            "check",
            "Says everything that is wrong in a job, or what it asks for.",
            "errormatch job check samples/complex-mating/job.json") =>
            Arguments.Add(_job);

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_job);
        if (InputFile.KindOfJob(file) == JobKind.Freeform)
        {
            return Freeform(new(file));
        }

        var job = InputFile.Job(file);
        _ = InputFile.DialectOf(job);
        foreach (var selector in job.Features.SelectMany(f => f.Blocks))
        {
            _ = BlockSelector.Parse(selector);
        }

        return new JobCheckAnswer(job);
    }

    private static FreeformCheckAnswer Freeform(FreeformFiles files)
    {
        var problems = new List<Refusal>();
        foreach (var read in new Action[] { () => files.Template(files.MeasuringDialect()), () => files.ToolpathDialect() })
        {
            try
            {
                read();
            }
            catch (InputException e) when (e.File == files.Job.File)
            {
                problems.AddRange(e.Refusals);
            }
        }

        return problems.Count == 0 ? new(files.Job) : throw new InputException(files.Job.File, problems);
    }
}
