namespace ErrorMatching.Json;

/// <summary>A key of an object and its value.</summary>
/// <param name="Name">The key.</param>
/// <param name="Place">The location of the key.</param>
/// <param name="Value">The value.</param>
public sealed record JsonMember(string Name, JsonPlace Place, JsonItem Value);
