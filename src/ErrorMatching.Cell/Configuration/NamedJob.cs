using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Cell;

/// <summary>A job's file as the cell needs it: a mating or a free-form job.</summary>
internal sealed class NamedJob
{
    private NamedJob(MatingJob? mating, FreeformJob? freeform) => (Mating, Freeform) = (mating, freeform);

    /// <summary>The mating; null for a free-form job.</summary>
    public MatingJob? Mating { get; }

    /// <summary>The free-form job; null for a mating.</summary>
    public FreeformJob? Freeform { get; }

    /// <summary>True if each file may be the part's or the counterpart's and the job's own rules say which.</summary>
    public bool Decides => Mating?.Recognition is not null;

    /// <summary>True if what is measured is what the program cut, so that corrections may add up.</summary>
    public bool IsFeedback => Mating?.Compensation.From == CompensationSource.Counterpart;

    /// <summary>The dialect of the program that goes to the machine: a name, or a shop's file as an absolute path.</summary>
    public string Dialect
    {
        get
        {
            var name = Mating?.Counterpart.Dialect ?? Freeform!.Toolpath.Dialect;
            return NcDialects.IsFile(name) ? Absolute(name) : name;
        }
    }

    /// <summary>The program that the job starts from; null for a free-form job, which makes one.</summary>
    public string? Program => Mating is null ? null : Absolute(Mating.Counterpart.Program);

    /// <summary>Absolute paths of the files that the job reads, besides those of dialects.</summary>
    public IReadOnlyList<string> Files => Mating is { } m
        ? [.. new[] { m.File, m.Part.Theoretical, m.Part.Measured, m.Counterpart.Measured, m.Counterpart.Program }.OfType<string>().Select(Absolute)]
        : [.. new[] { Freeform!.File, Freeform.Surface.File, Freeform.Measuring.Template }.OfType<string>().Select(Absolute)];

    /// <summary>The job in a file.</summary>
    /// <param name="file">The absolute path.</param>
    /// <exception cref="JsonDocumentException">It cannot be used.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It must not be read.</exception>
    public static NamedJob Read(string file)
    {
        var bytes = JsonInput.Load(file);
        var root = JsonInput.Read(bytes, file);
        try
        {
            return root.Kind == JsonItemKind.Object && root.Find("kind")?.Text == "freeform" ? new(null, FreeformJob.Parse(bytes, file)) : new(MatingJob.Parse(bytes, file), null);
        }
        catch (JobException e)
        {
            throw new JsonDocumentException(e.File, e.Problems);
        }
    }

    private string Absolute(string path) => Path.GetFullPath(Mating?.PathOf(path) ?? Freeform!.PathOf(path));
}
