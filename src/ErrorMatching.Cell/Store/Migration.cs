namespace ErrorMatching.Cell;

/// <summary>A numbered step of the database's form.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Name">What it is about.</param>
/// <param name="Sql">Its statements, with tokens such as <c>{blob}</c> where the engines have different words.</param>
internal sealed record Migration(int Number, string Name, string Sql);
