// The main job in ten lines: MainJob JOB FOLDER writes the counterpart's new program and its report, or says why there is none.
using ErrorMatching.Jobs;

var files = new JobFiles(args[0]);
var outcome = MatingRun.Of(files, new(), CancellationToken.None);
if (outcome.Result is not { } matched)
{
    foreach (var refusal in outcome.Refusals) Console.Error.WriteLine($"{refusal.Code}: {refusal.Message}");
    return 3;
}

OutputFile.WriteAll(
    [(Path.Combine(args[1], matched.Name), matched.Program), (Path.Combine(args[1], "report.html"), matched.ReportHtml())],
    files.Read,
    CancellationToken.None);
Console.WriteLine($"The proof {(matched.Report.Proof.Holds ? "holds" : "fails")}: {matched.Name}");
return 0;
