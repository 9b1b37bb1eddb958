using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Everything that is found wrong in a job while it is read.</summary>
internal sealed class JobProblems
{
    private readonly List<Refusal> _all = [];

    /// <summary>The problems in the order in which they were found.</summary>
    public IReadOnlyList<Refusal> All => _all;

    /// <summary>Adds a problem.</summary>
    public void Add(Refusal problem) => _all.Add(problem);

    /// <summary>Reads a value by a function that adds its problems to a list.</summary>
    public T Read<T>(Func<ICollection<Refusal>, T> read) => read(_all);

    /// <summary>Adds a problem with an item.</summary>
    public void Refuse(JsonItem item, string code, string found, string expected) => Add(JsonRefusal.At(item, code, found, expected));
}
