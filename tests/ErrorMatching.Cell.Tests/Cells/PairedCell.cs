using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A cell with a feedback job: counterparts are compared with the part of the same number,
/// and the program that cut them is corrected.</summary>
internal static class PairedCell
{
    public static readonly string Part = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv"));
    public static readonly string Counterpart = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "counterpart.csv"));

    private const string Names = """{ "fileName": "^((?<workOrder>WO[0-9]+)_)?(SN(?<serial>[0-9]+)_)?(part|cp)" }""";

    /// <summary>A cell whose files are named such as <c>WO1_SN7_part.csv</c>, each of the words before the piece as it likes.</summary>
    /// <param name="accumulates">Whether corrections add up.</param>
    /// <param name="memory">The machine.</param>
    /// <param name="twice">True if the configuration names the job's file once for each piece, false if the job has rules.</param>
    public static ConfiguredCell Of(bool accumulates, MemoryMachine memory, bool twice = false)
    {
        var jobs = twice
            ? $$"""
                { "name": "parts", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "part" }, "piece": "part", "machine": "m1", "slot": "A" },
                { "name": "counterparts", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "cp" }, "piece": "counterpart", "machine": "m1", "slot": "A" }
                """
            : $$"""{ "name": "f", "job": "job/job.json", "gauges": ["cmm"], "recognize": {{Names}}, "machine": "m1", "slot": "A", "accumulates": {{(accumulates ? "true" : "false")}} }""";
        var cell = new ConfiguredCell($$"""
            "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "finished": "rename", "everyMs": 20 }],
            "machines": [{ "name": "m1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m1" }, "attempts": 1, "slots": [{ "name": "A", "program": "P1.NC" }] }],
            "jobs": [{{jobs}}],
            "policy": { "approve": "automatic", "sumLimitMm": 5 }
            """) { Opens = _ => memory };
        cell.Copy("complex-mating", "job");
        cell.Change("job/job.json", "\"from\": \"part\"", "\"from\": \"counterpart\"");

        // Point 2 is at a corner that the tool leaves round: 0.146 mm stay, and what stays outside its limits waits for a person.
        const string Line = "\"blocks\": [\"N120\"], \"toleranceMm\": ";
        cell.Change("job/job.json", Line + "[-0.05, 0.05]", Line + "[-0.2, 0.2]");

        // What was corrected lies away from the drawing by the sum of corrections.
        cell.Change("job/job.json", "\"mapMm\": 0.5", "\"mapMm\": 3");
        if (!twice)
        {
            cell.Change("job/job.json", "\"alignment\"", """
                "recognition": { "part": [{ "in": "file-name", "pattern": "part" }], "counterpart": [{ "in": "file-name", "pattern": "cp" }] },
                  "alignment"
                """);
        }

        return cell;
    }
}
