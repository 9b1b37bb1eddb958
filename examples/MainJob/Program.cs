// The main job: MainJob JOB FOLDER writes the report and, if its verdict says to cut it, the counterpart's new program.
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

try
{
    var files = new JobFiles(args[0]);
    var outcome = MatingRun.Run(files);
    if (outcome.Result is not { } matched)
    {
        // The inputs can be read, but no program can be made from them.
        foreach (var refusal in outcome.Refusals)
        {
            Console.Error.WriteLine($"{refusal.Code}: {refusal.Message}");
        }

        return 2;
    }

    OutputFile.WriteAll(matched.FilesIn(args[1]), files.Opened);
    Console.WriteLine(VerdictWords.Of(matched.Report.Verdict));
    return matched.Report.Verdict.IsToCut ? 0 : 2;
}
catch (Exception e) when (e is InputException or OutputException)
{
    // A file cannot be read, or a result cannot be written: the message names the place and what is expected.
    Console.Error.WriteLine(e.Message);
    return 1;
}
