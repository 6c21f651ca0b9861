#include <statistics/model/design_matrix.hpp>

#include <algorithm>
#include <utility>

namespace tcert::statistics {
namespace {

using Column = Eigen::Map<const Eigen::VectorXd>;

/// The columns of one variable within one term: its numbers as they are, or made here.
struct Block {
  std::vector<Column> columns;
  std::vector<std::string> names;
  std::vector<Eigen::VectorXd> made;

  void view(std::string name, const std::vector<double>& x) {
    columns.emplace_back(x.data(), static_cast<Eigen::Index>(x.size()));
    names.push_back(std::move(name));
  }
  void add(std::string name, Eigen::VectorXd column) {
    made.push_back(std::move(column));
    columns.emplace_back(made.back().data(), made.back().size());
    names.push_back(std::move(name));
  }
};

const NamedVariable& find(const std::vector<NamedVariable>& variables, const Expression& wanted) {
  return *std::find_if(variables.begin(), variables.end(), [&](const NamedVariable& one) {
    return one.expression == wanted;
  });
}

/// Numbered as R numbers the columns of a matrix, of which a single one has none.
Block basis_block(const NamedVariable& variable) {
  Block block;
  const std::string name = to_string(variable.expression);
  for (const std::vector<double>& x : variable.value.basis) {
    block.view(
        variable.value.basis.size() == 1 ? name : name + std::to_string(block.names.size() + 1), x);
  }
  return block;
}

/// A factor of the levels FALSE and TRUE, whether both occur or not.
Block truth_block(const NamedVariable& variable, bool all_levels) {
  const std::vector<double>& truth = variable.value.numbers;
  const std::string name = to_string(variable.expression);
  Block block;
  if (all_levels) {
    block.add(name + "FALSE",
              1.0 - Column(truth.data(), static_cast<Eigen::Index>(truth.size())).array());
  }
  block.view(name + "TRUE", truth);
  return block;
}

Block factor_block(const NamedVariable& variable, bool all_levels) {
  const table::Factor& factor = variable.value.factor;
  Block block;
  for (std::size_t level = all_levels ? 0 : 1; level < factor.levels.size(); ++level) {
    Eigen::VectorXd column(static_cast<Eigen::Index>(factor.rows()));
    for (std::size_t row = 0; row < factor.rows(); ++row) {
      column[static_cast<Eigen::Index>(row)] = factor.codes[row] == level ? 1.0 : 0.0;
    }
    block.add(to_string(variable.expression) + factor.levels[level], std::move(column));
  }
  return block;
}

/// All products of a column of `a` and one of `b`; those of `a` vary fastest.
Block product(Block a, Block b) {
  if (a.names.empty()) {
    return b;
  }
  Block all;
  for (std::size_t j = 0; j < b.names.size(); ++j) {
    for (std::size_t i = 0; i < a.names.size(); ++i) {
      all.add(a.names[i] + ":" + b.names[j], a.columns[i].cwiseProduct(b.columns[j]));
    }
  }
  return all;
}

bool margin_is_in_model(const Formula& formula, const Term& term, const Expression& variable) {
  Term margin;
  std::copy_if(term.variables.begin(),
               term.variables.end(),
               std::back_inserter(margin.variables),
               [&](const Expression& one) { return !(one == variable); });
  return margin.variables.empty() ||
         std::any_of(formula.terms.begin(), formula.terms.end(), [&](const Term& one) {
           return same_term(one, margin);
         });
}

}  // namespace

DesignMatrix design_matrix(const Formula& formula,
                           const std::vector<NamedVariable>& variables,
                           std::size_t rows) {
  const auto n = static_cast<Eigen::Index>(rows);
  DesignMatrix design;
  std::vector<Block> blocks;
  if (formula.intercept) {
    design.columns.emplace_back("(Intercept)");
    design.term_of.push_back(0);
  }
  bool needs_all_levels = !formula.intercept;
  for (std::size_t t = 0; t < formula.terms.size(); ++t) {
    const Term& term = formula.terms[t];
    Block block;
    for (const Expression& expression : term.variables) {
      const NamedVariable& variable = find(variables, expression);
      if (variable.value.kind == Variable::Kind::number) {
        Block numbers;
        numbers.view(to_string(variable.expression), variable.value.numbers);
        block = product(std::move(block), std::move(numbers));
        continue;
      }
      if (variable.value.kind == Variable::Kind::basis) {
        block = product(std::move(block), basis_block(variable));
        continue;
      }
      const bool all = needs_all_levels || !margin_is_in_model(formula, term, expression);
      needs_all_levels = false;
      block = product(std::move(block),
                      variable.value.kind == Variable::Kind::truth ? truth_block(variable, all)
                                                                   : factor_block(variable, all));
    }
    design.columns.insert(design.columns.end(), block.names.begin(), block.names.end());
    design.term_of.resize(design.columns.size(), t + 1);
    blocks.push_back(std::move(block));
  }
  design.values.resize(n, static_cast<Eigen::Index>(design.columns.size()));
  Eigen::Index next = 0;
  if (formula.intercept) {
    design.values.col(next++).setOnes();
  }
  for (Block& block : blocks) {
    for (const Column& column : block.columns) {
      design.values.col(next++) = column;
    }
    block.made.clear();
  }
  return design;
}

}  // namespace tcert::statistics
