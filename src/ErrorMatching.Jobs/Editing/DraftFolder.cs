using System.Diagnostics.CodeAnalysis;
using System.Text.Json;
using System.Text.Json.Serialization;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The folder that stores unsaved changes of jobs, so that they survive a crash: one file per job, and the imported programs.
/// Each file is written completely or not at all.</summary>
/// <param name="folder">The folder, created when needed.</param>
public sealed class DraftFolder(string folder)
{
    private const long MostBytes = 64L << 20;

    /// <summary>Stores unsaved changes, replacing earlier ones of the same job.</summary>
    /// <exception cref="OutputException">They cannot be written.</exception>
    public void Keep(StoredDraft kept)
    {
        ArgumentNullException.ThrowIfNull(kept);
        if (kept.Draft.Program is { } program && !File.Exists(ProgramFile(kept.Job, program.Sha256)))
        {
            OutputFile.Write(ProgramFile(kept.Job, program.Sha256), program.Bytes, [], CancellationToken.None);
        }

        OutputFile.Write(
            DraftFile(kept.Job), JsonSerializer.SerializeToUtf8Bytes(kept, DraftJson.Default.StoredDraft), [], CancellationToken.None);
    }

    /// <summary>Reads the unsaved changes of a job; null if there are none.</summary>
    /// <exception cref="InputException">They cannot be read, or the file is invalid.</exception>
    public StoredDraft? Find(string job)
    {
        var file = DraftFile(job);
        if (!File.Exists(file))
        {
            return null;
        }

        return InputFile.Open(file, _ =>
        {
            try
            {
                var kept = JsonSerializer.Deserialize(InputFile.Bytes(file, MostBytes), DraftJson.Default.StoredDraft) is { } k
                    && k.Job == job
                    && k.Draft.IsWhole
                    ? k
                    : throw new IOException("It holds no unsaved changes of this job");
                return kept.Draft.Program is { } program ? kept with { Draft = kept.Draft with { Program = Read(job, program) } } : kept;
            }
            catch (JsonException e)
            {
                throw new IOException("It holds no unsaved changes of this version: " + e.Message, e);
            }
        });
    }

    /// <summary>Deletes the unsaved changes of a job, if any.</summary>
    /// <exception cref="OutputException">They cannot be deleted.</exception>
    public void Forget(string job)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        try
        {
            foreach (var file in Directory.EnumerateFiles(folder, Name(job) + ".*"))
            {
                File.Delete(file);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new OutputException(OutputException.Unwritable, folder, $"{folder} cannot be cleared: {e.Message}", e);
        }
    }

    private static DraftProgram Read(string path, string sha256)
    {
        var program = DraftProgram.Of(InputFile.Program(path));
        return program.Sha256 == sha256 ? program : throw new IOException("The imported program is not the one that was kept");
    }

    private DraftProgram Read(string job, DraftProgram program) => program.Sha256.All(char.IsAsciiLetterOrDigit)
        ? Read(ProgramFile(job, program.Sha256), program.Sha256)
        : throw new IOException("The imported program has no hash");

    private string DraftFile(string job) => Path.Combine(folder, Name(job) + ".draft.json");

    private string ProgramFile(string job, string sha256) => Path.Combine(folder, $"{Name(job)}.{sha256}.nc");

    // Job names may contain characters that file names must not.
    private static string Name(string job) => ContentHash.Sha256OfText(job)[..16];
}

/// <summary>Stored unsaved changes of a job.</summary>
public sealed record StoredDraft
{
    /// <summary>The job's name in the cell.</summary>
    public required string Job { get; init; }

    /// <summary>The user who made them.</summary>
    public required string By { get; init; }

    /// <summary>Time of the last change.</summary>
    public required DateTimeOffset At { get; init; }

    /// <summary>SHA-256 of the job's file that they are based on; empty if there was none.</summary>
    public required string BaseSha256 { get; init; }

    /// <summary>The draft.</summary>
    public required MatingDraft Draft { get; init; }
}

/// <summary>The format of stored drafts, made while the program is compiled: required values must not be null.</summary>
[JsonSourceGenerationOptions(RespectNullableAnnotations = true)]
[JsonSerializable(typeof(StoredDraft))]
[SuppressMessage("ApiDesign", "RS0030", Justification = "The generated code names a type without a culture.")]
internal sealed partial class DraftJson : JsonSerializerContext;
