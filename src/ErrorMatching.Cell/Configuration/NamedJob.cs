using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>A job's file with what the cell needs to know of it: a mating or a free-form job.</summary>
internal sealed class NamedJob
{
    private NamedJob(MatingJob? mating, FreeformJob? freeform) => (Mating, Freeform) = (mating, freeform);

    /// <summary>The mating; null for a free-form job.</summary>
    public MatingJob? Mating { get; }

    /// <summary>The free-form job; null for a mating.</summary>
    public FreeformJob? Freeform { get; }

    /// <summary>True if a file may be the part's or the counterpart's, and the job's own rules decide which.</summary>
    public bool Decides => Mating?.Recognition is not null;

    /// <summary>True if the measured piece is the one that the program cut, so that corrections may accumulate.</summary>
    public bool IsFeedback => Mating?.Compensation.From == CompensationSource.Counterpart;

    /// <summary>The dialect of the program that goes to the machine: a name, or the absolute path of a shop's own dialect file.</summary>
    public string Dialect
    {
        get
        {
            var name = Mating?.Counterpart.Dialect ?? Freeform!.Toolpath.Dialect;
            return NcDialects.IsFile(name) ? Absolute(name) : name;
        }
    }

    /// <summary>The job's base program; null for a free-form job, which generates one.</summary>
    public string? Program => Mating is null ? null : Absolute(Mating.Counterpart.Program);

    /// <summary>Absolute paths of the files that the job reads, except dialect files.</summary>
    public IReadOnlyList<string> Files => Mating is { } m
        ? [
            .. new[]
            {
                m.File,
                m.Part.Theoretical,
                m.Part.Measured,
                m.Counterpart.Measured,
                m.Counterpart.Program
            }.OfType<string>().Select(Absolute)]
        : [.. new[] { Freeform!.File, Freeform.Surface.File, Freeform.Measuring.Template }.OfType<string>().Select(Absolute)];

    /// <summary>Reads the job from a file.</summary>
    /// <param name="file">The absolute path.</param>
    /// <exception cref="InputException">The job is invalid.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static NamedJob Read(string file)
    {
        var bytes = JsonInput.Load(file);
        var root = JsonInput.Read(bytes, file);
        return root.Kind == JsonItemKind.Object && root.Find("kind")?.Text == "freeform"
            ? new(null, FreeformJob.Parse(bytes, file))
            : new(MatingJob.Parse(bytes, file), null);
    }

    private string Absolute(string path) => Path.GetFullPath(Mating?.PathOf(path) ?? Freeform!.PathOf(path));
}
