#include <statistics/model/design_matrix.hpp>

#include <algorithm>

namespace tcert::statistics {
namespace {

/// The columns of one variable within one term.
struct Block {
  std::vector<Eigen::VectorXd> columns;
  std::vector<std::string> names;
};

const NamedVariable& find(const std::vector<NamedVariable>& variables, const Expression& wanted) {
  return *std::find_if(variables.begin(), variables.end(), [&](const NamedVariable& one) {
    return one.expression == wanted;
  });
}

Block number_block(const NamedVariable& variable) {
  const std::vector<double>& x = variable.value.numbers;
  return {{Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()))},
          {to_string(variable.expression)}};
}

/// Numbered as R numbers the columns of a matrix, of which a single one has none.
Block basis_block(const NamedVariable& variable) {
  Block block;
  const std::string name = to_string(variable.expression);
  for (const std::vector<double>& x : variable.value.basis) {
    block.columns.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
    block.names.push_back(
        variable.value.basis.size() == 1 ? name : name + std::to_string(block.names.size() + 1));
  }
  return block;
}

/// A factor of the levels FALSE and TRUE, whether both occur or not.
Block truth_block(const NamedVariable& variable, bool all_levels) {
  const std::vector<double>& x = variable.value.numbers;
  const Eigen::Map<const Eigen::VectorXd> truth(x.data(), static_cast<Eigen::Index>(x.size()));
  const std::string name = to_string(variable.expression);
  Block block;
  if (all_levels) {
    block.columns.emplace_back(1.0 - truth.array());
    block.names.push_back(name + "FALSE");
  }
  block.columns.emplace_back(truth);
  block.names.push_back(name + "TRUE");
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
    block.columns.push_back(std::move(column));
    block.names.push_back(to_string(variable.expression) + factor.levels[level]);
  }
  return block;
}

/// All products of a column of `a` and one of `b`; those of `a` vary fastest.
Block product(const Block& a, const Block& b) {
  if (a.names.empty()) {
    return b;
  }
  Block all;
  for (std::size_t j = 0; j < b.names.size(); ++j) {
    for (std::size_t i = 0; i < a.names.size(); ++i) {
      all.columns.emplace_back(a.columns[i].cwiseProduct(b.columns[j]));
      all.names.push_back(a.names[i] + ":" + b.names[j]);
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
  std::vector<Eigen::VectorXd> columns;
  if (formula.intercept) {
    columns.emplace_back(Eigen::VectorXd::Ones(n));
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
        block = product(block, number_block(variable));
        continue;
      }
      if (variable.value.kind == Variable::Kind::basis) {
        block = product(block, basis_block(variable));
        continue;
      }
      const bool all = needs_all_levels || !margin_is_in_model(formula, term, expression);
      needs_all_levels = false;
      block = product(block,
                      variable.value.kind == Variable::Kind::truth ? truth_block(variable, all)
                                                                   : factor_block(variable, all));
    }
    for (std::size_t k = 0; k < block.names.size(); ++k) {
      columns.push_back(std::move(block.columns[k]));
      design.columns.push_back(std::move(block.names[k]));
      design.term_of.push_back(t + 1);
    }
  }
  design.values.resize(n, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    design.values.col(static_cast<Eigen::Index>(k)) = columns[k];
    columns[k].resize(0);
  }
  return design;
}

}  // namespace tcert::statistics
