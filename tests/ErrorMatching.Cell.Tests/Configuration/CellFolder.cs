using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A folder with a configuration, its jobs and an incoming folder, removed behind the test.</summary>
internal sealed class CellFolder : IDisposable
{
    public const string HostKey = "ssh-ed25519 AAAAC3NzaC1lZDI1NTE5AAAAIAABAgMEBQYHCAkKCwwNDg8QERITFBUWFxgZGhscHR4f";

    public const string Right = """
        {
          "kind": "cell", "name": "Cell 1",
          "store": { "kind": "sqlite", "file": "store/cell.db" },
          "keys": "keys", "logs": "logs",
          "gauges": [
            { "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename" },
            { "name": "probe", "machine": "vmc2", "files": "PROBE.LOG", "format": "probing-log", "finished": { "endMark": "END" }, "keep": true }
          ],
          "machines": [
            { "name": "vmc1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "machine" },
              "slots": [{ "name": "A", "program": "O2001.NC", "readyFile": "A.READY" }, { "name": "B", "program": "O2002.NC" }] },
            { "name": "vmc2", "dialect": "siemens-840d", "transport": { "kind": "ftp", "host": "vmc2", "user": "nc", "folder": "/nc", "tls": "none" },
              "slots": [{ "name": "A", "program": "FINISH.MPF" }] },
            { "name": "vmc3", "dialect": "delta-nc300",
              "transport": { "kind": "sftp", "host": "vmc3", "user": "nc", "hostKey": "ssh-ed25519 AAAAC3NzaC1lZDI1NTE5AAAAIAABAgMEBQYHCAkKCwwNDg8QERITFBUWFxgZGhscHR4f" },
              "slots": [{ "name": "A", "program": "O3001.NC" }] }
          ],
          "jobs": [
            { "name": "housing", "job": "jobs/mating.json", "gauges": ["cmm"], "machine": "vmc1", "slot": "A", "order": "serial",
              "recognize": { "fileName": "^(?<workOrder>WO-[0-9]+)_(?<serial>[A-Z0-9]+)\\.csv$" } },
            { "name": "feedback", "job": "jobs/feedback.json", "gauges": ["cmm"], "machine": "vmc1", "slot": "B", "accumulates": true,
              "recognize": { "fileName": "^fb_", "column": { "name": "serial", "pattern": "^(?<serial>[0-9]+)$" } }, "policy": { "sumLimitMm": 0.6 } },
            { "name": "cover", "job": "jobs/ruled.json", "gauges": ["cmm"], "machine": "vmc3", "slot": "A",
              "recognize": { "fileName": "^cover", "column": { "name": "serial", "pattern": "^(?<serial>C[0-9]+)$" } } },
            { "name": "blade", "job": "jobs/freeform.json", "gauges": ["probe"], "machine": "vmc2", "slot": "A", "program": "jobs/cam.nc",
              "recognize": { "headerField": { "name": "PLAN", "pattern": "^[0-9A-F]{16}$" } } }
          ],
          "policy": { "approve": "automatic", "limitMm": 0.2, "sumLimitMm": 0.5, "gain": 1.0 }
        }
        """;

    public CellFolder()
    {
        var mating = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json"));
        Write("jobs/mating.json", mating);
        Write("jobs/feedback.json", mating.Replace("\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal)
            .Replace("\"counterpart.nc\"", "\"O2002.nc\"", StringComparison.Ordinal));
        Write("jobs/ruled.json", mating.Replace("\"counterpart.nc\"", "\"O3001.nc\"", StringComparison.Ordinal).Replace(
            "\"alignment\"",
            """
            "recognition": { "part": [{ "in": "file-name", "pattern": "-part" }], "counterpart": [{ "in": "file-name", "pattern": "-cp" }] },
              "alignment"
            """,
            StringComparison.Ordinal));
        Write("jobs/freeform.json", File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json")));
        Directory.CreateDirectory(PathOf("incoming"));
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-cell-").FullName;

    public string PathOf(string name) => Path.Combine(Folder, name);

    public string Write(string name, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(PathOf(name))!);
        File.WriteAllText(PathOf(name), text);
        return PathOf(name);
    }

    public CellSettings Read(string text) => CellSettingsReader.Read(Write("cell.json", text));

    /// <summary>The right configuration with one text in place of another, which must be in it once.</summary>
    public static string With(string old, string text)
    {
        Assert.Equal(2, Right.Split(old).Length);
        return Right.Replace(old, text, StringComparison.Ordinal);
    }

    public void Dispose() => Directory.Delete(Folder, recursive: true);
}
